// Computes the bounds of a frame; see bounds.hpp.
#include "zstrip/state/bounds.hpp"

#include <algorithm>

namespace zstrip::detail {
namespace {

struct PositionBox {
  Position low{-32768, -32768, -32768}, high{32767, 32767, 32767};
};

/// Converts a raster coordinate to pixels. Values from the guard band on mean "outside every picture".
std::int32_t pixels(std::int32_t numerator, const Reciprocal& r, std::int32_t shift, std::int32_t bias,
                    bool orthographic) {
  const int total = 32 + shift - (orthographic ? 0 : r.normalisation);
  const std::int64_t product =
      orthographic ? std::int64_t{numerator} * (std::int64_t{1} << 32) : std::int64_t{numerator} * r.value;
  constexpr std::int64_t kBeyond = std::int64_t{1} << kGuardBits;
  const std::int64_t coordinate = total >= 0 ? product >> total : (product > 0 ? kBeyond : -kBeyond);
  return (static_cast<std::int32_t>(std::clamp(coordinate, -kBeyond, kBeyond)) + bias) >> 4;
}

Rect pixels_of(const PositionBox& positions, const CompiledInstance& instance, const RasterOrigin& origin,
               const View& view, bool orthographic) {
  const Rect whole{0, 0, view.width, view.height};
  Rect box{INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN};
  for (int corner = 0; corner < 8; ++corner) {
    const Position p{(corner & 1) != 0 ? positions.high.x : positions.low.x,
                     (corner & 2) != 0 ? positions.high.y : positions.low.y,
                     (corner & 4) != 0 ? positions.high.z : positions.low.z};
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
  // One pixel more on each side, because the roundings of the projection add up to less than that.
  const std::int32_t centre_x = view.width >> 1;
  const std::int32_t centre_y = view.height >> 1;
  const Rect cut{std::max(box.left - 1 + centre_x, whole.left), std::max(box.top - 1 + centre_y, whole.top),
                 std::min(box.right + 2 + centre_x, whole.right), std::min(box.bottom + 2 + centre_y, whole.bottom)};
  return cut.empty() ? Rect{} : cut;
}

/// Returns the sphere's cube, in positions. The radius is in units of the largest half extent, more units of a smaller
/// one.
PositionBox cube_of(const Meshlet& meshlet, const Mesh& mesh) {
  const Vec3& half = mesh.half_extent;
  const std::int32_t largest = std::max(std::max(half.x, half.y), half.z);
  PositionBox box;
  const auto side = [&](std::int16_t centre, Fixed extent, std::int16_t& low, std::int16_t& high) {
    if (extent <= 0) return;  // flat: all positions are valid
    const std::int64_t reach = (std::int64_t{meshlet.radius} * largest + extent - 1) / extent + 1;
    low = static_cast<std::int16_t>(std::max<std::int64_t>(centre - reach, -32768));
    high = static_cast<std::int16_t>(std::min<std::int64_t>(centre + reach, 32767));
  };
  side(meshlet.centre.x, half.x, box.low.x, box.high.x);
  side(meshlet.centre.y, half.y, box.low.y, box.high.y);
  side(meshlet.centre.z, half.z, box.low.z, box.high.z);
  return box;
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
  return pixels_of({}, instance, origin, view, orthographic);
}

Rect bounds_with_border(const CompiledInstance& instance, std::int32_t border, const RasterOrigin& origin,
                        const View& view, bool orthographic) {
  // Computed in a picture with a border, so that parts outside this picture that reach into it are not lost. The border
  // keeps the size odd or even.
  View wider = view;
  wider.width = static_cast<std::uint16_t>(view.width + 2 * border);
  wider.height = static_cast<std::uint16_t>(view.height + 2 * border);
  const Rect box = bounds_of(instance, origin, wider, orthographic);
  if (box.empty()) return {};
  const Rect cut{std::max<std::int32_t>(box.left - 2 * border, 0), std::max<std::int32_t>(box.top - 2 * border, 0),
                 std::min<std::int32_t>(box.right, view.width), std::min<std::int32_t>(box.bottom, view.height)};
  return cut.empty() ? Rect{} : cut;
}

SphereBounds sphere_bounds(const CompiledInstance& instance, const Mesh& mesh, const Meshlet* meshlet,
                           const RasterOrigin& origin, const View& view, bool orthographic) {
  const PositionBox positions = meshlet != nullptr ? cube_of(*meshlet, mesh) : PositionBox{};
  SphereBounds bounds{pixels_of(positions, instance, origin, view, orthographic), largest_depth_code(DepthFormat::z16)};
  const auto& [low, high] = positions;
  const LinearForm& w = instance.w;
  const Position nearest{w.x < 0 ? high.x : low.x, w.y < 0 ? high.y : low.y, w.z < 0 ? high.z : low.z};
  // Three products of the form are rounded down.
  const std::int32_t distance = w.at(nearest) - 3;
  if (distance <= static_cast<std::int32_t>(instance.w_near)) return bounds;
  if (static_cast<std::uint32_t>(distance) - instance.w_near > instance.w_range) {  // beyond the depth range
    bounds.box = {};
    return bounds;
  }
  const Reciprocal r = orthographic ? Reciprocal{0, 0} : reciprocal_of(static_cast<std::uint32_t>(distance));
  const std::uint32_t depth = orthographic ? project_depth<true>(instance, origin, distance, r)
                                           : project_depth<false>(instance, origin, distance, r);
  bounds.nearest = std::min((depth >> 16) + 1, bounds.nearest);
  return bounds;
}

}  // namespace zstrip::detail
