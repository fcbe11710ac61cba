// The order in which a tree gives its triangles to an eye.
#pragma once

#include <cstddef>
#include <cstdint>

#include "zstrip/scene/camera.hpp"
#include "zstrip/scene/scene.hpp"
#include "zstrip/visibility/bsp_tree.hpp"

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
/// result; also false if the tree is none for a mesh of so many triangles. Never more than kMostBspDepth nodes wait.
template <class Visit>
bool for_each_bsp_run(const BspTree& tree, const BspEye& eye, std::size_t triangles, const Visit& visit) {
  if (tree.nodes.empty()) return true;
  // A node waits after its far side has been entered, and is followed by its near side.
  std::uint32_t waiting[kMostBspDepth];
  std::uint32_t count = 0;
  std::uint32_t index = 0;
  bool any = true;
  std::size_t visited = 0;
  for (;;) {
    if (any) {
      const BspNode& node = tree.nodes[index];
      if (count == kMostBspDepth || ++visited > tree.nodes.size()) return false;
      waiting[count++] = index;
      const std::uint32_t far = lies_in_front(node, eye) ? node.back : node.front;
      if (far != 0 && (far <= index || far >= tree.nodes.size())) return false;
      any = far != 0;
      index = far;
      continue;
    }
    if (count == 0) return true;
    index = waiting[--count];
    const BspNode& node = tree.nodes[index];
    if (node.first_triangle > triangles || node.triangle_count > triangles - node.first_triangle) return false;
    if (!visit(node.first_triangle, node.triangle_count)) return false;
    const std::uint32_t near = lies_in_front(node, eye) ? node.front : node.back;
    if (near != 0 && (near <= index || near >= tree.nodes.size())) return false;
    any = near != 0;
    index = near;
  }
}

}  // namespace zstrip::detail
