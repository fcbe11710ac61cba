// The eye in the space of a mesh; see bsp_order.hpp.
#include "zstrip/visibility/bsp_order.hpp"

#include <algorithm>

#include "zstrip/geometry/depth_fit.hpp"

namespace zstrip::detail {

BspEye bsp_eye(const Mesh& mesh, const Transform& transform, const Camera& camera) {
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
    // The inverse of a rotation with a scale is its transpose by the square of the scale.
    std::int64_t along = 0;  // 32.32; with a direction 18.46 >> 14
    for (int row = 0; row < 3; ++row) {
      const std::int64_t from = is_direction ? back[row] >> 14 : std::int64_t{eye[row]} - transform.m[row][3];  // 17.16
      along += from * transform.m[row][axis];
    }
    const std::int64_t object = along / squared_scale - (is_direction ? 0 : centre[axis]);  // 48.16
    // A flat box: the eye is where the only plane is, or far on either side.
    constexpr std::int64_t kFarthest = std::int64_t{1} << 29;
    const std::int64_t in_box = half[axis] > 0
                                    ? std::clamp(object, -(kFarthest << 16), kFarthest << 16) * 65536 / half[axis]
                                    : (object > 0 ? kFarthest : -kFarthest);
    result[axis] = std::clamp(in_box, -kFarthest, kFarthest);
  }
  return {result[0], result[1], result[2], is_direction};
}

}  // namespace zstrip::detail
