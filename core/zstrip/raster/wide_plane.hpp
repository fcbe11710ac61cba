// Planes for depth that 32 bits cannot step over a picture: 24 and 32 bits, and divisions by a small 1/w.
#pragma once

#include <cstdint>

#include "zstrip/base/math.hpp"
#include "zstrip/raster/plane.hpp"

namespace zstrip::detail {

/// Fraction bits that a wide plane has beyond those of its value.
inline constexpr int kWideBits = 20;

/// Like Plane, of a 32-bit value with kWideBits more: stepped over 4096 columns and rows it errs by less than 1/200
/// unit of the value. Arithmetic modulo 2^64, exact in the 52 bits that count.
struct WidePlane {
  using Value = std::uint64_t;
  std::uint64_t start, step_x, step_y;

  constexpr std::uint64_t at(std::int32_t columns, std::int32_t rows) const {
    return start + step_x * static_cast<std::uint64_t>(std::int64_t{columns}) +
           step_y * static_cast<std::uint64_t>(std::int64_t{rows});
  }
};

/// The plane through three depths, by exact division; `area` and the anchor as for PlaneSetup.
inline WidePlane wide_depth_plane(const RasterVertex& v0, const RasterVertex& v1, const RasterVertex& v2,
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
