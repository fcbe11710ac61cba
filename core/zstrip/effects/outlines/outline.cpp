// Computes how far an outline's vertices are moved, once an instance and frame.
#include "zstrip/effects/outlines/outline.hpp"

#include <bit>

#include "zstrip/base/direction.hpp"

namespace zstrip::detail {
namespace {

/// Returns the width in 1/16 raster pixels along x.
std::int64_t width_across(std::uint16_t width, const View& view) { return std::int64_t{width} * sample_columns(view); }

/// Returns the 1/16 raster pixels of a unit of length (perspective: at distance 1) along x, with 16 fraction bits.
std::int64_t sixteenths(const Camera& camera, const View& view) { return std::int64_t{camera.focal} * view.height * 8; }

/// Returns how far a unit normal extends along the viewing direction. Perspective: in 1/2^30 of the distance, at most
/// half of it; orthographic: a length.
std::int64_t reach_of_normal(std::uint16_t width, const Camera& camera, const View& view) {
  const bool orthographic = camera.projection == Projection::orthographic;
  const std::int64_t limit = (std::int64_t{1} << (orthographic ? 59 : 29)) - 1;
  // Below 2^9 << 53; `sixteenths` has 16 fraction bits.
  const std::int64_t share = (width_across(width, view) << 53) / sixteenths(camera, view);
  static_assert(kDistanceBits + 16 == 54);
  return std::min(orthographic ? share << 1 : share >> (53 - 46), limit);
}

/// `sign` is 1, or -1 for the opposite direction.
void set_axis(ObjectLight& to, const Vec3& axis, std::int64_t sign, const Transform& transform) {
  const std::int64_t world[3] = {sign * axis.x, sign * axis.y, sign * axis.z};
  std::int64_t turned[3] = {};  // multiplied by the transform's transpose: 9.16 * 2.30, three terms: below 2^56
  for (int column = 0; column < 3; ++column) {
    for (int k = 0; k < 3; ++k) turned[column] += transform.m[k][column] * world[k];
  }
  const Wide3 wide{turned[0], turned[1], turned[2]};
  to = {};
  if (wide == Wide3{0, 0, 0}) return;
  const Vec3 direction = unit(wide);
  // A normal's component of 1 is 127.
  const auto component = [](std::int32_t c) {
    return static_cast<std::int16_t>((std::int64_t{c} * 128 / 127 + (1 << 15)) >> 16);
  };
  to.x = component(direction.x);
  to.y = component(direction.y);
  to.z = component(direction.z);
}

}  // namespace

DistanceRange with_outline(const DistanceRange& range, std::uint16_t width, const Camera& camera, const View& view) {
  const std::int64_t reach = reach_of_normal(width, camera, view);
  const auto at = [&](Distance distance) {
    return camera.projection == Projection::orthographic ? reach : ((magnitude(distance) >> 16) * (reach >> 14)) + 1;
  };
  return {range.nearest - at(range.nearest), range.farthest + at(range.farthest)};
}

void make_outline(CompiledInstance& hull, const Outline& outline, const Transform& transform, const Camera& camera,
                  const View& view, const DepthFit& fit) {
  hull.shade = Shade::flat;
  hull.lit = hull.coloured = hull.double_sided = false;
  hull.base = outline.colour;
  hull.light_count = kOutlineLights;
  set_axis(hull.lights[0], camera.right, 1, transform);
  set_axis(hull.lights[1], camera.up, -1, transform);
  set_axis(hull.lights[2], camera.back, -1, transform);
  std::int64_t reach = reach_of_normal(outline.width, camera, view);
  if (camera.projection == Projection::orthographic) {
    // The instance's w is the distance, shifted right by as many bits as its far value is.
    const auto bits = [](std::int64_t value) { return 64 - std::countl_zero(static_cast<std::uint64_t>(value)); };
    const int shift = bits(fit.far) - bits(std::int64_t{hull.w_near} + hull.w_range);
    constexpr std::int64_t kLimit = (std::int64_t{1} << 29) - 1;
    if (shift >= 0) {
      reach = std::min(reach >> shift, kLimit);
    } else {
      reach = reach > kLimit >> -shift ? kLimit : reach << -shift;
    }
  }
  ObjectLight& moves = hull.lights[3];
  moves = {};
  moves.x = static_cast<std::int16_t>(width_across(outline.width, view));
  moves.y = static_cast<std::int16_t>(outline.width * sample_rows(view));
  while ((reach >> moves.r) > INT16_MAX) ++moves.r;
  moves.z = static_cast<std::int16_t>(reach >> moves.r);
}

}  // namespace zstrip::detail
