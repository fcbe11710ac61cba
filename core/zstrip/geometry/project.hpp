// Projects the linear forms of a position to snapped picture coordinates and depth. The narrow vertices of the fast
// path and the wide ones of the clipping path use the same formula: a vertex that both accept gets the same
// coordinates.
#pragma once

#include <bit>
#include <cstdint>

#include "zstrip/base/processor.hpp"
#include "zstrip/effects.hpp"
#include "zstrip/geometry/instance.hpp"
#include "zstrip/scene/depth_format.hpp"

namespace zstrip::detail {

/// Raster coordinates: 1/16 pixels relative to pixel (width / 2, height / 2), plus kCentreBias, so that
/// coordinate >> 4 is the first pixel whose centre is not to the left of it. Pixel p's centre is at 16 p +
/// kPixelCentre.
inline constexpr std::int32_t kCentreBias = 7;
inline constexpr std::int32_t kPixelCentre = 8 + kCentreBias;

/// Narrow coordinates: any difference fits 15 bits and a sign, a product of two 31, so that areas and edges of narrow
/// triangles need 32 bits.
inline constexpr std::int32_t kNarrowLimit = 1024 * 16;
/// Wide coordinates: within 2^21 pixels, the guard band.
inline constexpr int kGuardBits = 25;

/// The frame's constants of the mapping to raster coordinates.
struct RasterOrigin {
  std::int32_t bias_x, bias_y;  ///< kCentreBias, plus half a pixel if the size is odd
  std::uint32_t depth_offset;   ///< subtracted from k / w, modulo 2^32 (perspective); added (orthographic)
};

constexpr RasterOrigin raster_origin(const View& view, const DepthFit& fit, bool orthographic) {
  return {kCentreBias + 8 * (view.width & 1), kCentreBias + 8 * (view.height & 1),
          static_cast<std::uint32_t>(orthographic ? kDepthOfFar : fit.offset)};
}

/// A vertex in the post-transform cache. x == kNotNarrow: outside the narrow range or the depth range; its triangles
/// take the clipping path.
struct SnappedVertex {
  std::int16_t x, y;    ///< 12.4 raster coordinates
  std::uint32_t depth;  ///< 16.16 codes
};
static_assert(sizeof(SnappedVertex) == kVertexBytes);
inline constexpr std::int16_t kNotNarrow = INT16_MIN;

struct Reciprocal {
  std::int32_t value;  ///< 2^(62 - normalisation) / w
  int normalisation;
};
constexpr Reciprocal reciprocal_of(std::uint32_t w) {
  const int normalisation = std::countl_zero(w);
  return {reciprocal(w << normalisation), normalisation};
}
/// `likely`: the probable number of leading zeros of w, 0 .. 31. A processor that cannot count them tries this number
/// first.
constexpr Reciprocal reciprocal_of(std::uint32_t w, int likely) {
  if (kCountsZeros || w >> (31 - likely) != 1) [[unlikely]]
    return reciprocal_of(w);
  return {reciprocal(w << likely), likely};
}

/// Snaps the depth of a vertex in any format to odd eighths of a code, as snap_depth does for z16. The smallest code is
/// 1.
template <DepthFormat format>
constexpr std::uint32_t snap_depth_as(std::uint32_t depth) {
  if constexpr (format == DepthFormat::float16) {
    const std::uint32_t eighth = 1U << (9 + float16_octave(depth));
    const std::uint32_t snapped = (depth & ~(2 * eighth - 1)) | eighth;
    return snapped < (1U << 12) ? (1U << 12) | eighth : snapped;
  } else if constexpr (format == DepthFormat::z24) {
    return (depth & ~0x3FU) | 0x20U;
  } else {
    return snap_depth(depth);
  }
}

/// Returns the snapped depth of a vertex at distance w (in the instance's scale) inside the depth range, in 1/2^32 of
/// all codes: 16.16 codes of z16, 24.8 of z24; near / w in 0.32 for float16.
template <bool orthographic, DepthFormat format = DepthFormat::z16>
constexpr std::uint32_t project_depth(const CompiledInstance& instance, const RasterOrigin& origin, std::int32_t w,
                                      const Reciprocal& r) {
  if constexpr (format != DepthFormat::z16) {
    // Uses all bits of the product, because these formats keep them.
    if constexpr (orthographic) {
      const std::uint32_t from_far = instance.w_near + instance.w_range - static_cast<std::uint32_t>(w);
      const std::uint64_t product = std::uint64_t{from_far << instance.depth_normalisation} * instance.depth_scale;
      return snap_depth_as<format>(static_cast<std::uint32_t>(product >> (32 - instance.depth_shift)) +
                                   origin.depth_offset);
    } else {
      const std::uint64_t product = std::uint64_t{static_cast<std::uint32_t>(r.value)} * instance.depth_scale;
      const int shift = 32 + instance.depth_normalisation - r.normalisation - instance.depth_shift;
      return snap_depth_as<format>(static_cast<std::uint32_t>(product >> shift) - origin.depth_offset);
    }
  } else if constexpr (orthographic) {
    const std::uint32_t from_far = instance.w_near + instance.w_range - static_cast<std::uint32_t>(w);
    const std::uint32_t scaled = multiply_high(from_far << instance.depth_normalisation, instance.depth_scale);
    return snap_depth((scaled << instance.depth_shift) + origin.depth_offset);
  } else {
    const auto relative = static_cast<std::uint32_t>(r.value) >> (instance.depth_normalisation - r.normalisation);
    return snap_depth((multiply_high(relative, instance.depth_scale) << instance.depth_shift) - origin.depth_offset);
  }
}

/// Values of an instance that project_narrow needs for all of its vertices.
template <bool orthographic>
struct NarrowProjection {
  std::uint32_t w_near, w_range;  ///< range of w in which a vertex may be narrow
  std::int32_t shift_x, shift_y;  ///< to 1/32 pixels; with perspective for a w with normalisation 0
  std::int32_t bias_x, bias_y;    ///< RasterOrigin's bias in 1/32 pixels, plus half of 1/16 to round to nearest

  constexpr NarrowProjection(const CompiledInstance& instance, const RasterOrigin& origin)
      : w_near(instance.w_near),
        w_range(instance.w_range),
        shift_x(instance.shift_x - 1),
        shift_y(instance.shift_y - 1),
        bias_x(2 * origin.bias_x + 1),
        bias_y(2 * origin.bias_y + 1) {
    const std::int32_t smaller = shift_x < shift_y ? shift_x : shift_y;
    // A vertex so near that the shift would be negative takes the clipping path.
    const std::uint32_t nearest = smaller < 0    ? 0xFFFFFFFF
                                  : orthographic ? 0
                                  : smaller < 31 ? std::uint32_t{1} << (31 - smaller)
                                                 : 0;
    if (nearest > w_near) {
      const std::uint32_t nearer = nearest - w_near;
      w_near = nearest;
      w_range -= nearer;
      if (nearer > instance.w_range) w_near = 0x80000000, w_range = 0;  // empty: |w| < 2^31
    }
  }
};

/// Projects and snaps a vertex. Returns false if it is not narrow. `x`, `y`, `w` are the instance's linear forms at the
/// vertex. `normalisation`: on entry the probable one of w, 0 .. 31, such as the last vertex's; on return that of a w
/// in range.
template <bool orthographic, DepthFormat format = DepthFormat::z16>
inline bool project_narrow(const NarrowProjection<orthographic>& narrow, const CompiledInstance& instance,
                           const RasterOrigin& origin, std::int32_t x, std::int32_t y, std::int32_t w,
                           SnappedVertex& vertex, int& normalisation) {
  if (static_cast<std::uint32_t>(w) - narrow.w_near > narrow.w_range) return false;
  Reciprocal r{0, 0};
  if constexpr (!orthographic) {
    r = reciprocal_of(static_cast<std::uint32_t>(w), normalisation);
    normalisation = r.normalisation;
    x = multiply_high(x, r.value);
    y = multiply_high(y, r.value);
  }
  // Rounded to nearest, halves up.
  const std::int32_t px = ((x >> (narrow.shift_x - r.normalisation)) + narrow.bias_x) >> 1;
  const std::int32_t py = ((y >> (narrow.shift_y - r.normalisation)) + narrow.bias_y) >> 1;
  // Tests both at once: a sum outside 0 .. 2 kNarrowLimit has a higher bit set.
  static_assert(std::has_single_bit(static_cast<std::uint32_t>(kNarrowLimit)));
  if ((static_cast<std::uint32_t>(px + kNarrowLimit) | static_cast<std::uint32_t>(py + kNarrowLimit)) >=
      static_cast<std::uint32_t>(2 * kNarrowLimit)) {
    return false;
  }
  vertex.x = static_cast<std::int16_t>(px);
  vertex.y = static_cast<std::int16_t>(py);
  vertex.depth = project_depth<orthographic, format>(instance, origin, w, r);
  return true;
}
template <bool orthographic, DepthFormat format = DepthFormat::z16>
inline bool project_narrow(const NarrowProjection<orthographic>& narrow, const CompiledInstance& instance,
                           const RasterOrigin& origin, std::int32_t x, std::int32_t y, std::int32_t w,
                           SnappedVertex& vertex) {
  int unknown = 0;
  return project_narrow<orthographic, format>(narrow, instance, origin, x, y, w, vertex, unknown);
}

}  // namespace zstrip::detail
