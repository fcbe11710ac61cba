// Computes the camera of a shadow map, once a frame in 64-bit arithmetic; see light_view.hpp.
#include "zstrip/effects/shadows/light_view.hpp"

#include <algorithm>

namespace zstrip::detail {
namespace {

constexpr int kToFixed = kDistanceBits - kFixedBits;
constexpr std::int64_t kMaxWord = INT32_MAX;

Vec3 negated(const Vec3& v) { return {-v.x, -v.y, -v.z}; }

Vec3 shortened(const Vec3& axis, std::int64_t factor) {
  const auto times = [factor](std::int32_t c) { return static_cast<std::int32_t>((c * factor) >> 30); };
  return {times(axis.x), times(axis.y), times(axis.z)};
}

/// Returns half of the length that the picture shows, 16.16: half of the reach, a pixel more, and the rounding errors.
std::int64_t half_of(const DistanceRange& range, std::uint32_t side) {
  const std::int64_t half = ((range.farthest - range.nearest) >> (kToFixed + 1)) + 1;
  return half + half * 2 / (std::int64_t{side} - 2) + 4;
}

}  // namespace

LightReach::LightReach(const DirectionalLight& light) {
  // A light without a direction shines from above.
  const bool none = light.x == 0 && light.y == 0 && light.z == 0;
  Camera seen;
  static_cast<void>(look_at(seen, {light.x, none ? 1 : light.y, light.z}, {0, 0, 0}, {0, 0, 0}));
  for (Camera& axis : axes) axis.eye = {0, 0, 0};
  axes[0].back = negated(seen.right);
  axes[1].back = negated(seen.up);
  axes[2].back = seen.back;
}

Status light_camera(Camera& camera, const LightReach& reach, std::uint32_t side) {
  const Status failure{.error = Error::shadow};
  const Vec3 right = negated(reach.axes[0].back), up = negated(reach.axes[1].back), back = reach.axes[2].back;
  std::int64_t half_x = half_of(reach.along[0], side), half_y = half_of(reach.along[1], side);
  // Both halves must be large enough for their reciprocals, and the smaller one for some bits of its axis.
  const std::int64_t larger = std::max<std::int64_t>(std::max(half_x, half_y), 256);
  if (larger > kMaxWord) return failure;
  half_x = std::max(half_x, std::max<std::int64_t>(larger >> 6, 256));
  half_y = std::max(half_y, std::max<std::int64_t>(larger >> 6, 256));
  const std::int64_t focal = (std::int64_t{1} << 32) / std::min(half_x, half_y) + 1;
  // If the scene is flat when seen from the light, its depth is enlarged: otherwise a code would be smaller than the
  // precision of positions.
  const std::int64_t reach_away = ((reach.along[2].farthest - reach.along[2].nearest) >> kToFixed) + 2;
  const std::int64_t depth = std::max(reach_away, larger >> 4);
  const std::int64_t near = std::max<std::int64_t>(depth >> 4, 64);
  if (near + depth + 8 > kMaxWord) return failure;

  const auto middle = [](const DistanceRange& range) {
    return (range.nearest >> (kToFixed + 1)) + (range.farthest >> (kToFixed + 1));
  };
  const std::int64_t at[3] = {middle(reach.along[0]), middle(reach.along[1]),
                              near + 4 - (reach.along[2].nearest >> kToFixed)};
  for (const std::int64_t coordinate : at) {
    if (coordinate > kMaxWord || coordinate < -kMaxWord) return failure;
  }
  const auto sum = [&at](std::int32_t a, std::int32_t b, std::int32_t c) {
    return (a * at[0] + b * at[1] + c * at[2]) >> 30;
  };
  const std::int64_t eye[3] = {sum(right.x, up.x, back.x), sum(right.y, up.y, back.y), sum(right.z, up.z, back.z)};
  for (const std::int64_t coordinate : eye) {
    if (coordinate > kMaxWord || coordinate < -kMaxWord) return failure;
  }
  const auto share = [focal](std::int64_t half) {
    return (std::int64_t{1} << 62) / (focal * half);
  };  // 2.30, at most 1
  camera.right = shortened(right, share(half_x));
  camera.up = shortened(up, share(half_y));
  camera.back = back;
  camera.eye = {static_cast<Fixed>(eye[0]), static_cast<Fixed>(eye[1]), static_cast<Fixed>(eye[2])};
  camera.focal = static_cast<Fixed>(focal);
  camera.near_plane = static_cast<Fixed>(near);
  camera.far_plane = static_cast<Fixed>(near + depth + 8);
  camera.projection = Projection::orthographic;
  camera.fixed_depth_range = true;
  return {};
}

}  // namespace zstrip::detail
