// Bounds of a frame; see bounds.hpp.
#include "zstrip/frame/bounds.hpp"

#include <algorithm>

namespace zstrip::detail {
namespace {

/// Pixels of a raster coordinate; the guard band and more stand for "beyond any picture".
std::int32_t pixels(std::int32_t numerator, const Reciprocal& r, std::int32_t shift, std::int32_t bias,
                    bool orthographic) {
  const int total = 32 + shift - (orthographic ? 0 : r.normalisation);
  const std::int64_t product =
      orthographic ? std::int64_t{numerator} * (std::int64_t{1} << 32) : std::int64_t{numerator} * r.value;
  constexpr std::int64_t kBeyond = std::int64_t{1} << kGuardBits;
  const std::int64_t coordinate = total >= 0 ? product >> total : (product > 0 ? kBeyond : -kBeyond);
  return (static_cast<std::int32_t>(std::clamp(coordinate, -kBeyond, kBeyond)) + bias) >> 4;
}

}  // namespace

DistanceRange reach_of(const Scene& scene, const Camera& camera) {
  DistanceRange reach = kNoReach;
  for (const Instance& instance : scene.instances) {
    extend(reach, distance_range(scene.meshes[instance.mesh], instance.transform, camera), camera);
  }
  return reach;
}

DepthFit fit_to(const DistanceRange& reach, const Camera& camera) {
  const Distance near = distance_of(camera.near_plane);
  const Distance far = distance_of(camera.far_plane);
  if (reach.nearest > reach.farthest) return {};
  if (camera.fixed_depth_range) return fit_depth(near, far);
  return fit_depth(std::max(reach.nearest, near), std::min(reach.farthest, far));
}

Rect bounds_of(const CompiledInstance& instance, const RasterOrigin& origin, const View& view, bool orthographic) {
  const Rect whole{0, 0, view.width, view.height};
  Rect box{INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN};
  for (int corner = 0; corner < 8; ++corner) {
    const auto side = [corner](int axis) { return static_cast<std::int16_t>((corner >> axis) & 1 ? 32767 : -32768); };
    const Position p{side(0), side(1), side(2)};
    const std::int32_t w = instance.w.at(p);
    Reciprocal r{0, 0};
    if (!orthographic) {
      if (w < static_cast<std::int32_t>(instance.w_near)) return whole;  // a corner behind the near plane
      r = reciprocal_of(static_cast<std::uint32_t>(w));
    }
    const std::int32_t x = pixels(instance.x.at(p), r, instance.shift_x, origin.bias_x, orthographic);
    const std::int32_t y = pixels(instance.y.at(p), r, instance.shift_y, origin.bias_y, orthographic);
    box = {std::min(box.left, x), std::min(box.top, y), std::max(box.right, x), std::max(box.bottom, y)};
  }
  // One pixel more on each side: every rounding of the projection is below that.
  const std::int32_t centre_x = view.width >> 1;
  const std::int32_t centre_y = view.height >> 1;
  const Rect cut{std::max(box.left - 1 + centre_x, whole.left), std::max(box.top - 1 + centre_y, whole.top),
                 std::min(box.right + 2 + centre_x, whole.right), std::min(box.bottom + 2 + centre_y, whole.bottom)};
  return cut.empty() ? Rect{} : cut;
}

}  // namespace zstrip::detail
