// The order in which a tree gives its triangles to an eye.
#pragma once

#include <cstddef>
#include <cstdint>

#include "zstrip/camera.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/scene/bsp_tree.hpp"

namespace zstrip::detail {

/// Where the camera is, or with an orthographic one from where it looks, in the mesh's bounding box.
struct BspEye {
  std::int64_t x, y, z;  ///< 48.16 half extents, within +-8192
  bool is_direction;
};
/// For a transform of rotation, uniform scale and translation.
BspEye bsp_eye(const Mesh& mesh, const Transform& transform, const Camera& camera);

/// Whether the eye is in front of the node's plane.
constexpr bool lies_in_front(const BspNode& node, const BspEye& eye) {
  // 2.30 by 14.16, three terms: below 2^63.
  const std::int64_t side = node.x * eye.x + node.y * eye.y + node.z * eye.z;
  return side > (eye.is_direction ? 0 : std::int64_t{node.distance} * 65536);
}

/// Calls visit(first, count) for the runs of triangles from far to near, until it returns false, which is then the
/// result; also false if the tree is none for a mesh of so many triangles.
template <class Visit>
bool for_each_bsp_run(const BspTree& tree, const BspEye& eye, std::size_t triangles, const Visit& visit) {
  const std::span<const BspNode> nodes = tree.nodes;
  if (nodes.empty() || nodes[0].first_triangle != 0) return nodes.empty();
  enum class From : std::uint8_t { parent, far, near };
  From from = From::parent;
  std::uint32_t index = 0;
  std::size_t visited = 0;
  for (;;) {
    const BspNode& node = nodes[index];
    const bool in_front = lies_in_front(node, eye);
    const std::uint32_t far = in_front ? node.back : node.front;
    const std::uint32_t near = in_front ? node.front : node.back;
    if (from == From::far || (from == From::parent && far == 0)) {
      const std::size_t end = index + 1 < nodes.size() ? nodes[index + 1].first_triangle : triangles;
      if (end > triangles || node.first_triangle > end || ++visited > nodes.size()) return false;
      if (!visit(node.first_triangle, static_cast<std::uint32_t>(end - node.first_triangle))) return false;
    }
    const std::uint32_t child = from == From::parent && far != 0 ? far : from != From::near ? near : 0;
    if (child != 0) {
      if (child <= index || child >= nodes.size() || nodes[child].parent != index || near == far) return false;
      from = From::parent;
      index = child;
      continue;
    }
    if (index == 0) return visited == nodes.size();
    const BspNode& parent = nodes[node.parent];  // which has this child: it was entered from there
    from = index == (lies_in_front(parent, eye) ? parent.back : parent.front) ? From::far : From::near;
    index = node.parent;
  }
}

}  // namespace zstrip::detail
