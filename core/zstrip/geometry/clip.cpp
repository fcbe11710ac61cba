// Sutherland-Hodgman clipping; see clip.hpp.
#include "zstrip/geometry/clip.hpp"

#include "zstrip/geometry/project.hpp"

namespace zstrip::detail {
namespace {

/// Signed distance to a plane of the clip volume, >= 0 inside: a*x + b*y + c*w + d. Exact: below 2^55.
struct Plane {
  std::int64_t x, y, w, offset;

  std::int64_t at(const ClipVertex& v) const { return x * v.x + y * v.y + w * v.w + offset; }
};

/// The point where the edge crosses the plane. Always computed from the inner vertex, so that both neighbours agree.
ClipVertex crossing(const ClipVertex& inner, const ClipVertex& outer, std::int64_t inside, std::int64_t outside) {
  // inside >= 0 > outside. fraction = inside / (inside - outside) in 0.31, operands first brought to 31 bits.
  std::uint64_t numerator = static_cast<std::uint64_t>(inside);
  std::uint64_t denominator = static_cast<std::uint64_t>(inside) + (~static_cast<std::uint64_t>(outside) + 1);
  const int surplus = 32 - std::countl_zero(denominator);
  if (surplus > 0) numerator >>= surplus, denominator >>= surplus;
  const auto fraction = static_cast<std::int64_t>((numerator << 31) / denominator);
  const auto between = [fraction](std::int32_t from, std::int32_t to) {
    return static_cast<std::int32_t>(from + (((std::int64_t{to} - from) * fraction) >> 31));
  };
  return {between(inner.x, outer.x), between(inner.y, outer.y), between(inner.w, outer.w), between(inner.r, outer.r),
          between(inner.g, outer.g), between(inner.b, outer.b), between(inner.u, outer.u), between(inner.v, outer.v)};
}

void clip_against(ClipPolygon& polygon, const Plane& plane) {
  ClipPolygon kept;
  kept.count = 0;
  for (int i = 0; i < polygon.count; ++i) {
    const ClipVertex& a = polygon.vertices[i];
    const ClipVertex& b = polygon.vertices[i + 1 < polygon.count ? i + 1 : 0];
    const std::int64_t at_a = plane.at(a);
    const std::int64_t at_b = plane.at(b);
    // A convex polygon gains at most one vertex a plane; rounding could add more, which must not leave the array.
    if (at_a >= 0 && kept.count < kMaxPolygon) kept.vertices[kept.count++] = a;
    if ((at_a < 0) != (at_b < 0) && kept.count < kMaxPolygon) {
      kept.vertices[kept.count++] = at_a >= 0 ? crossing(a, b, at_a, at_b) : crossing(b, a, at_b, at_a);
    }
  }
  polygon = kept;
}

/// Near and far first: behind them the guard band's planes are meaningless.
void clip_depth(ClipPolygon& polygon, const CompiledInstance& instance) {
  const std::int64_t near = instance.w_near;
  const std::int64_t far = near + instance.w_range;
  clip_against(polygon, {0, 0, 1, -near});
  clip_against(polygon, {0, 0, -1, far});
  // The crossing rounds: put the new vertices exactly into the range.
  for (int i = 0; i < polygon.count; ++i) {
    std::int32_t& w = polygon.vertices[i].w;
    if (w < near) w = static_cast<std::int32_t>(near);
    if (w > far) w = static_cast<std::int32_t>(far);
  }
}

}  // namespace

void clip_perspective(ClipPolygon& polygon, const CompiledInstance& instance) {
  clip_depth(polygon, instance);
  // |x| / w * 2^(30 - shift) <= 2^kGuardBits  <=>  |x| * 2^(30 - shift) <= w * 2^kGuardBits; 0 <= shift <= 31.
  const auto guard = [](std::int32_t shift) {
    const int exponent = kGuardBits - 30 + shift;  // -8 .. 23
    struct Scales {
      std::int64_t coordinate, w;
    };
    return exponent >= 0 ? Scales{1, std::int64_t{1} << exponent} : Scales{std::int64_t{1} << -exponent, 1};
  };
  const auto gx = guard(instance.shift_x);
  const auto gy = guard(instance.shift_y);
  clip_against(polygon, {gx.coordinate, 0, gx.w, 0});
  clip_against(polygon, {-gx.coordinate, 0, gx.w, 0});
  clip_against(polygon, {0, gy.coordinate, gy.w, 0});
  clip_against(polygon, {0, -gy.coordinate, gy.w, 0});
}

void clip_orthographic(ClipPolygon& polygon, const CompiledInstance& instance) {
  clip_depth(polygon, instance);
  // |x| * 2^-shift <= 2^kGuardBits.
  const auto guard = [](std::int32_t shift) { return std::int64_t{1} << (kGuardBits + shift); };
  clip_against(polygon, {1, 0, 0, guard(instance.shift_x)});
  clip_against(polygon, {-1, 0, 0, guard(instance.shift_x)});
  clip_against(polygon, {0, 1, 0, guard(instance.shift_y)});
  clip_against(polygon, {0, -1, 0, guard(instance.shift_y)});
}

}  // namespace zstrip::detail
