// Sutherland-Hodgman clipping; see clip.hpp.
#include "zstrip/geometry/clip.hpp"

#include <algorithm>
#include <iterator>

#include "zstrip/base/division.hpp"

namespace zstrip::detail {
namespace {

using Component = std::int64_t ClipVertex::*;
using Varying = std::int32_t ClipVertex::*;
constexpr Component kPlaces[] = {&ClipVertex::x, &ClipVertex::y, &ClipVertex::w};
constexpr Varying kVaryings[] = {&ClipVertex::r, &ClipVertex::g, &ClipVertex::b, &ClipVertex::u, &ClipVertex::v};

/// A plane of the clip volume. A guard band's plane ignores fraction bits to keep the distance below 2^58.
struct CutPlane {
  Component along;
  std::int64_t scale, w, d;  ///< signed distance scale * along + w * w + d, >= 0 inside
  int bits;                  ///< fraction bits of the vertex that are ignored

  [[gnu::noinline]] std::int64_t at(const ClipVertex& v) const {
    return scale * (v.*along >> bits) + w * (v.w >> bits) + d;
  }
};

// Linear forms are below 2^30; a difference of two must be below 2^47 for Fraction::of.
static_assert(30 + kClipBits + 1 <= 47);

/// A fraction 0..1 with 62 bits. An edge from far before to far behind the camera crosses a plane where w is small,
/// which needs all of them.
struct Fraction {
  std::uint32_t high, low;  // (high + low / 2^31) / 2^31

  /// Computes numerator / denominator, 0 <= numerator <= denominator > 0.
  Fraction(std::uint64_t numerator, std::uint64_t denominator) {
    const int surplus = 32 - std::countl_zero(denominator);
    if (surplus > 0) numerator >>= surplus, denominator >>= surplus;
    const auto divisor = static_cast<std::uint32_t>(denominator);
    const QuotientAndRest first = divide_long(numerator << 31, divisor);
    high = first.quotient;
    low = divide_long(std::uint64_t{first.rest} << 31, divisor).quotient;
  }
  /// |value| < 2^47.
  [[gnu::noinline]] std::int64_t of(std::int64_t value) const {
    return scaled(value, high) + (scaled(value, low) >> 31);
  }

 private:
  static std::int64_t scaled(std::int64_t value, std::uint32_t factor) {
    return (((value >> 16) * std::int64_t{factor}) >> 15) + (((value & 0xFFFF) * std::int64_t{factor}) >> 31);
  }
};

/// Returns the point where the edge crosses the plane. It is computed from the inner vertex, so that both neighbours
/// get the same point.
ClipVertex crossing(const ClipVertex& inner, const ClipVertex& outer, std::int64_t inside, std::int64_t outside) {
  // inside >= 0 > outside
  const Fraction fraction(static_cast<std::uint64_t>(inside),
                          static_cast<std::uint64_t>(inside) - static_cast<std::uint64_t>(outside));
  ClipVertex made;
  for (const Component place : kPlaces) {
    made.*place = inner.*place + fraction.of(outer.*place - inner.*place);
  }
  for (const Varying varying : kVaryings) {
    made.*varying =
        static_cast<std::int32_t>(inner.*varying + fraction.of(std::int64_t{outer.*varying} - inner.*varying));
  }
  return made;
}

/// Clips in place, so that the stack holds one polygon. The polygon is moved to the end of its memory, with its first
/// vertex repeated after the last one, and read from there, while the result is written from the beginning. A cut
/// convex polygon grows by one vertex at most; a polygon that rounding made concave may grow by more. The memory is
/// large enough: an edge produces two vertices at most, the result has kMaxPolygon at most, and the result ends before
/// the vertices that are still to be read.
void clip_against(ClipPolygon& polygon, const CutPlane& plane) {
  if (polygon.count == 0) return;
  // Most planes cut nothing, and then nothing is copied.
  std::int64_t least = 0;
  for (int i = 0; i < polygon.count; ++i) least = std::min(least, plane.at(polygon.vertices[i]));
  if (least == 0) return;
  ClipVertex* const end = std::end(polygon.vertices) - 1;
  ClipVertex* a = end;
  for (int i = polygon.count; i-- > 0;) *--a = polygon.vertices[i];
  *end = *a;
  polygon.count = 0;
  const auto keep = [&polygon](const ClipVertex& vertex) {
    if (polygon.count < kMaxPolygon) polygon.vertices[polygon.count++] = vertex;
  };
  for (std::int64_t at_a = plane.at(*a); a != end; ++a) {
    const std::int64_t at_b = plane.at(a[1]);
    if (at_a >= 0) keep(*a);
    if ((at_a ^ at_b) < 0) keep(at_a >= 0 ? crossing(a[0], a[1], at_a, at_b) : crossing(a[1], a[0], at_b, at_a));
    at_a = at_b;
  }
}

/// Clips against two opposite planes, `plane` and the one with -scale and `far`.
void clip_between(ClipPolygon& polygon, CutPlane plane, std::int64_t far) {
  clip_against(polygon, plane);
  plane.scale = -plane.scale, plane.d = far;
  clip_against(polygon, plane);
}

/// Clips against near and far first: the guard band's planes have no meaning behind these.
void clip_depth(ClipPolygon& polygon, const CompiledInstance& instance) {
  const std::int64_t near = std::int64_t{instance.w_near} << kClipBits;
  const std::int64_t far = near + (std::int64_t{instance.w_range} << kClipBits);
  clip_between(polygon, {&ClipVertex::w, 1, 0, -near, 0}, far);
  // Crossings are rounded: moves the new vertices exactly into the range.
  for (int i = 0; i < polygon.count; ++i) {
    std::int64_t& w = polygon.vertices[i].w;
    w = std::clamp(w, near, far);
  }
}

/// |along| / w * 2^(30 - shift) <= 2^kGuardBits  <=>  |along| * 2^(30 - shift) <= w * 2^kGuardBits; 0 <= shift <= 31.
void clip_guard_band(ClipPolygon& polygon, Component along, std::int32_t shift) {
  const int exponent = kGuardBits - 30 + shift;
  // w * 2^exponent is below 2^(46 - bits + exponent): 2^57.
  const int bits = std::max(0, exponent - 11);
  const auto power = [](int of_two) { return std::int64_t{1} << std::max(0, of_two); };
  clip_between(polygon, {along, power(-exponent), power(exponent), 0, bits}, 0);
}

}  // namespace

void clip_perspective(ClipPolygon& polygon, const CompiledInstance& instance) {
  clip_depth(polygon, instance);
  clip_guard_band(polygon, &ClipVertex::x, instance.shift_x);
  clip_guard_band(polygon, &ClipVertex::y, instance.shift_y);
}

void clip_orthographic(ClipPolygon& polygon, const CompiledInstance& instance) {
  clip_depth(polygon, instance);
  // |x| * 2^-shift <= 2^kGuardBits.
  const auto guard = [&polygon](Component along, std::int32_t shift) {
    const std::int64_t limit = std::int64_t{1} << (kGuardBits + shift);
    clip_between(polygon, {along, 1, 0, limit, kClipBits}, limit);
  };
  guard(&ClipVertex::x, instance.shift_x);
  guard(&ClipVertex::y, instance.shift_y);
}

template <bool orthographic>
WidePosition project_wide(const CompiledInstance& instance, const RasterOrigin& origin, const ClipVertex& vertex) {
  // Normalises w with all of its bits; leading zeros are counted as for w without the extra fraction.
  const auto w = static_cast<std::uint64_t>(vertex.w);
  const int zeros = std::countl_zero(w);
  const int normalisation = zeros - (32 - kClipBits);
  const auto normalised = static_cast<std::uint32_t>((w << zeros) >> 32);
  const std::int32_t r = orthographic ? 0 : reciprocal(normalised);
  const auto snapped = [&](std::int64_t numerator, std::int32_t shift, std::int32_t bias) {
    // floor(numerator * r / 2^32), exact; below 2^45.
    const std::int64_t product =
        orthographic ? numerator
                     : (numerator >> 32) * r +
                           static_cast<std::int64_t>(((numerator & 0xFFFFFFFF) * static_cast<std::uint64_t>(r)) >> 32);
    const int total = shift + kClipBits - (orthographic ? 0 : normalisation);
    if (total < 1) return static_cast<std::int32_t>(product << -total) + bias;
    return static_cast<std::int32_t>((product + (std::int64_t{1} << (total - 1))) >> total) + bias;
  };
  const auto whole_w = static_cast<std::int32_t>(vertex.w >> kClipBits);
  return {snapped(vertex.x, instance.shift_x, origin.bias_x), snapped(vertex.y, instance.shift_y, origin.bias_y),
          project_depth<orthographic>(instance, origin, whole_w, {r, normalisation})};
}

template WidePosition project_wide<false>(const CompiledInstance&, const RasterOrigin&, const ClipVertex&);
template WidePosition project_wide<true>(const CompiledInstance&, const RasterOrigin&, const ClipVertex&);

}  // namespace zstrip::detail
