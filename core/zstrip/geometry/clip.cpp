// Sutherland-Hodgman clipping; see clip.hpp.
#include "zstrip/geometry/clip.hpp"

#include <algorithm>

namespace zstrip::detail {
namespace {

/// Signed distance to a plane of the clip volume, >= 0 inside. The planes of the guard band leave out as many fraction
/// bits as they must for a*x + b*y + c*w + d to be below 2^58.
struct Plane {
  std::int64_t x, y, w, offset;
  int bits;  ///< fraction bits of the vertex that do not count

  std::int64_t at(const ClipVertex& v) const {
    return x * (v.x >> bits) + y * (v.y >> bits) + w * (v.w >> bits) + offset;
  }
};

// Linear forms are below 2^30; a difference of two must be below 2^47 for Fraction::of.
static_assert(30 + kClipBits + 1 <= 47);

/// A fraction 0..1 with 62 bits: the crossing of an edge that runs from far before to far behind the camera has a
/// small w, which needs them.
struct Fraction {
  std::int64_t high, low;  // (high + low / 2^31) / 2^31

  /// numerator / denominator, 0 <= numerator <= denominator > 0.
  static Fraction of(std::uint64_t numerator, std::uint64_t denominator) {
    const int surplus = 32 - std::countl_zero(denominator);
    if (surplus > 0) numerator >>= surplus, denominator >>= surplus;
    const std::uint64_t first = numerator << 31;
    const std::uint64_t second = (first % denominator) << 31;
    return {static_cast<std::int64_t>(first / denominator), static_cast<std::int64_t>(second / denominator)};
  }
  /// value * fraction for |value| < 2^47.
  std::int64_t of(std::int64_t value) const { return scaled(value, high) + (scaled(value, low) >> 31); }

 private:
  static std::int64_t scaled(std::int64_t value, std::int64_t factor) {
    return (((value >> 16) * factor) >> 15) + (((value & 0xFFFF) * factor) >> 31);
  }
};

/// The point where the edge crosses the plane. Always computed from the inner vertex, so that both neighbours agree.
ClipVertex crossing(const ClipVertex& inner, const ClipVertex& outer, std::int64_t inside, std::int64_t outside) {
  // inside >= 0 > outside
  const Fraction fraction =
      Fraction::of(static_cast<std::uint64_t>(inside),
                   static_cast<std::uint64_t>(inside) + (~static_cast<std::uint64_t>(outside) + 1));
  const auto wide = [&](std::int64_t from, std::int64_t to) { return from + fraction.of(to - from); };
  const auto narrow = [&](std::int32_t from, std::int32_t to) {
    return static_cast<std::int32_t>(from + fraction.of(std::int64_t{to} - from));
  };
  return {wide(inner.x, outer.x),   wide(inner.y, outer.y),   wide(inner.w, outer.w),   narrow(inner.r, outer.r),
          narrow(inner.g, outer.g), narrow(inner.b, outer.b), narrow(inner.u, outer.u), narrow(inner.v, outer.v)};
}

/// In place, so that the stack holds one polygon: it is moved to the end of its memory and read from there, while what
/// is kept is written from the beginning on. A cut convex polygon grows by one vertex at most; where rounding has made
/// it concave it may grow by more, and there is room for that.
void clip_against(ClipPolygon& polygon, const Plane& plane) {
  const int count = polygon.count;
  if (count == 0) return;
  constexpr int kRoom = static_cast<int>(sizeof polygon.vertices / sizeof polygon.vertices[0]);
  ClipVertex* const source = polygon.vertices + (kRoom - count);
  for (int i = count; i-- > 0;) source[i] = polygon.vertices[i];
  const ClipVertex first = source[0];
  const std::int64_t at_first = plane.at(first);
  ClipVertex a = first;
  std::int64_t at_a = at_first;
  int kept = 0;
  for (int i = 0; i < count; ++i) {
    const bool last = i + 1 == count;
    const ClipVertex b = last ? first : source[i + 1];
    const std::int64_t at_b = last ? at_first : plane.at(b);
    // What has not been read must not be overwritten.
    const int limit = last ? kMaxPolygon : std::min(kMaxPolygon, kRoom - count + i + 2);
    if (at_a >= 0 && kept < limit) polygon.vertices[kept++] = a;
    if ((at_a < 0) != (at_b < 0) && kept < limit) {
      polygon.vertices[kept++] = at_a >= 0 ? crossing(a, b, at_a, at_b) : crossing(b, a, at_b, at_a);
    }
    a = b;
    at_a = at_b;
  }
  polygon.count = kept;
}

/// Near and far first: behind them the guard band's planes are meaningless.
void clip_depth(ClipPolygon& polygon, const CompiledInstance& instance) {
  const std::int64_t near = std::int64_t{instance.w_near} << kClipBits;
  const std::int64_t far = near + (std::int64_t{instance.w_range} << kClipBits);
  clip_against(polygon, {0, 0, 1, -near, 0});
  clip_against(polygon, {0, 0, -1, far, 0});
  // The crossing rounds: put the new vertices exactly into the range.
  for (int i = 0; i < polygon.count; ++i) {
    std::int64_t& w = polygon.vertices[i].w;
    if (w < near) w = near;
    if (w > far) w = far;
  }
}

}  // namespace

void clip_perspective(ClipPolygon& polygon, const CompiledInstance& instance) {
  clip_depth(polygon, instance);
  // |x| / w * 2^(30 - shift) <= 2^kGuardBits  <=>  |x| * 2^(30 - shift) <= w * 2^kGuardBits; 0 <= shift <= 31.
  struct Scales {
    std::int64_t coordinate, w;
    int bits;  ///< w * 2^exponent is below 2^(46 - bits + exponent): 2^57
  };
  const auto guard = [](std::int32_t shift) {
    const int exponent = kGuardBits - 30 + shift;
    return exponent >= 0 ? Scales{1, std::int64_t{1} << exponent, std::max(0, exponent - 11)}
                         : Scales{std::int64_t{1} << -exponent, 1, 0};
  };
  const Scales x = guard(instance.shift_x);
  const Scales y = guard(instance.shift_y);
  clip_against(polygon, {x.coordinate, 0, x.w, 0, x.bits});
  clip_against(polygon, {-x.coordinate, 0, x.w, 0, x.bits});
  clip_against(polygon, {0, y.coordinate, y.w, 0, y.bits});
  clip_against(polygon, {0, -y.coordinate, y.w, 0, y.bits});
}

void clip_orthographic(ClipPolygon& polygon, const CompiledInstance& instance) {
  clip_depth(polygon, instance);
  // |x| * 2^-shift <= 2^kGuardBits.
  const auto guard = [](std::int32_t shift) { return std::int64_t{1} << (kGuardBits + shift); };
  clip_against(polygon, {1, 0, 0, guard(instance.shift_x), kClipBits});
  clip_against(polygon, {-1, 0, 0, guard(instance.shift_x), kClipBits});
  clip_against(polygon, {0, 1, 0, guard(instance.shift_y), kClipBits});
  clip_against(polygon, {0, -1, 0, guard(instance.shift_y), kClipBits});
}

template <bool orthographic, ReciprocalOf kind>
WidePosition project_wide(const CompiledInstance& instance, const RasterOrigin& origin, const ClipVertex& vertex) {
  // w normalised from all of its bits; the leading zeros are counted as for w without the extra fraction.
  const auto w = static_cast<std::uint64_t>(vertex.w);
  const int zeros = std::countl_zero(w);
  const int normalisation = zeros - (32 - kClipBits);
  const auto normalised = static_cast<std::uint32_t>((w << zeros) >> 32);
  const std::int32_t r = orthographic ? 0 : reciprocal_as<kind>(normalised);
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
template WidePosition project_wide<false, ReciprocalOf::quotient>(const CompiledInstance&, const RasterOrigin&,
                                                                  const ClipVertex&);
template WidePosition project_wide<false, ReciprocalOf::table>(const CompiledInstance&, const RasterOrigin&,
                                                               const ClipVertex&);
template WidePosition project_wide<true>(const CompiledInstance&, const RasterOrigin&, const ClipVertex&);

}  // namespace zstrip::detail
