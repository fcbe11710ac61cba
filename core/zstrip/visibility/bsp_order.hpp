// Walks a tree's triangles in the order for an eye.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip/camera.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/scene/bsp_tree.hpp"

namespace zstrip::detail {

/// The position of the camera in the mesh's bounding box; for an orthographic camera the direction from which it looks.
struct BspEye {
  std::int64_t x, y, z;  ///< 48.16 half extents, within +-8192
  bool is_direction;
};
/// Computes the eye for a transform of rotation, uniform scale and translation.
[[gnu::noinline]] inline BspEye bsp_eye(const Mesh& mesh, const Transform& transform, const Camera& camera) {
  const bool is_direction = camera.projection == Projection::orthographic;
  const Fixed eye[3] = {camera.eye.x, camera.eye.y, camera.eye.z};
  const std::int32_t back[3] = {camera.back.x, camera.back.y, camera.back.z};
  const Fixed centre[3] = {mesh.centre.x, mesh.centre.y, mesh.centre.z};
  const Fixed half[3] = {mesh.half_extent.x, mesh.half_extent.y, mesh.half_extent.z};
  std::int64_t squared_scale = 0;  // 32.32
  for (const auto& row : transform.m) squared_scale += std::int64_t{row[0]} * row[0];
  squared_scale = std::max<std::int64_t>(squared_scale >> 16, 1);  // 16.16
  std::int64_t result[3];
  for (int axis = 0; axis < 3; ++axis) {
    // The inverse of a rotation with a scale is its transpose divided by the square of the scale.
    std::int64_t along = 0;  // 32.32; with a direction 18.46 >> 14
    for (int row = 0; row < 3; ++row) {
      const std::int64_t from = is_direction ? back[row] >> 14 : std::int64_t{eye[row]} - transform.m[row][3];  // 17.16
      along += from * transform.m[row][axis];
    }
    const std::int64_t object = along / squared_scale - (is_direction ? 0 : centre[axis]);  // 48.16
    // In a flat box the eye lies on the only plane, or far away on either side.
    constexpr std::int64_t kFarthest = std::int64_t{1} << 29;
    const std::int64_t in_box = half[axis] > 0
                                    ? std::clamp(object, -(kFarthest << 16), kFarthest << 16) * 65536 / half[axis]
                                    : (object > 0 ? kFarthest : -kFarthest);
    result[axis] = std::clamp(in_box, -kFarthest, kFarthest);
  }
  return {result[0], result[1], result[2], is_direction};
}

constexpr bool lies_in_front(const BspNode& node, const BspEye& eye) {
  // 2.30 times 14.16, three terms: below 2^63.
  const std::int64_t side = node.x * eye.x + node.y * eye.y + node.z * eye.z;
  return side > (eye.is_direction ? 0 : std::int64_t{node.distance} * 65536);
}

/// Calls visit(first, count) for the runs of triangles from far to near, until it returns false. Returns false then,
/// and also if the tree is not one for a mesh with this number of triangles.
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
    const BspNode& parent = nodes[node.parent];  // the walk entered this child from its parent
    from = index == (lies_in_front(parent, eye) ? parent.back : parent.front) ? From::far : From::near;
    index = node.parent;
  }
}

}  // namespace zstrip::detail
