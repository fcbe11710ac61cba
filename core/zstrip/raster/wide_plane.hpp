// The plane of 32-bit depth, by exact division: a reciprocal has too few bits.
#pragma once

#include <cstdint>

#include "zstrip/base/math.hpp"
#include "zstrip/raster/plane.hpp"

namespace zstrip::detail {

/// The plane through three depths; `area` and the anchor as for PlaneSetup.
inline WidePlane exact_depth_plane(const RasterVertex& v0, const RasterVertex& v1, const RasterVertex& v2,
                                   std::int64_t area, std::int32_t anchor_x, std::int32_t anchor_y) {
  const std::int64_t d1 = std::int64_t{v1.depth} - v0.depth;
  const std::int64_t d2 = std::int64_t{v2.depth} - v0.depth;
  const std::int64_t along_x = d1 * (v0.y - v2.y) + d2 * (v1.y - v0.y);
  const std::int64_t along_y = -(d1 * (v0.x - v2.x) + d2 * (v1.x - v0.x));
  // A pixel is 2^4 sub-pixels; 8 more bits, so that nothing is lost on the way to the anchor.
  constexpr int kBits = kWideBits + 8 + 4;
  const auto step_x = static_cast<std::uint64_t>(long_quotient(along_x, area, kBits));
  const auto step_y = static_cast<std::uint64_t>(long_quotient(along_y, area, kBits));
  const std::uint64_t to_anchor =
      step_x * static_cast<std::uint64_t>(std::int64_t{anchor_x} * 16 + kPixelCentre - v0.x) +
      step_y * static_cast<std::uint64_t>(std::int64_t{anchor_y} * 16 + kPixelCentre - v0.y);
  return {(std::uint64_t{v0.depth} << kWideBits) + (to_anchor >> 12), (step_x + 128) >> 8, (step_y + 128) >> 8};
}

}  // namespace zstrip::detail
