// Sets up values that are linear over a triangle of any size, exactly.
#pragma once

#include <cstdint>

#include "zstrip/base/math.hpp"
#include "zstrip/base/processor.hpp"
#include "zstrip/geometry/project.hpp"

namespace zstrip::detail {

/// A vertex of the span rasteriser, narrow or wide.
struct RasterVertex {
  std::int32_t x, y;     ///< 28.4 raster coordinates, within the guard band
  std::uint32_t depth;   ///< 16.16 codes
  std::int32_t r, g, b;  ///< 8.16, see channel_start
  std::int32_t u, v;     ///< texels, 16.16
};

/// Returns twice the signed area in 1/256 square pixels; positive for counter-clockwise triangles (y up).
constexpr std::int64_t signed_area(const RasterVertex& a, const RasterVertex& b, const RasterVertex& c) {
  return std::int64_t{c.x - a.x} * (b.y - a.y) - std::int64_t{b.x - a.x} * (c.y - a.y);
}

/// A value at the anchor pixel and its steps a pixel. Arithmetic is modulo 2^32, so that it is exact wherever the value
/// itself is in range.
struct Plane {
  using Value = std::uint32_t;
  std::uint32_t start, step_x, step_y;

  constexpr std::uint32_t at(std::int32_t columns, std::int32_t rows) const {
    return start + step_x * static_cast<std::uint32_t>(columns) + step_y * static_cast<std::uint32_t>(rows);
  }
};

struct ColourPlanes {
  Plane r, g, b;  ///< 8.16
};

/// Fraction bits of a wide plane in addition to those of its value.
inline constexpr int kWideBits = 20;

/// Like Plane, for a 32-bit value with kWideBits more bits: the error over 4096 columns and rows is below 1/200 unit of
/// the value. Arithmetic is modulo 2^64, exact in the 52 bits that are used.
struct WidePlane {
  using Value = std::uint64_t;
  std::uint64_t start, step_x, step_y;

  constexpr std::uint64_t at(std::int32_t columns, std::int32_t rows) const {
    return start + step_x * static_cast<std::uint64_t>(std::int64_t{columns}) +
           step_y * static_cast<std::uint64_t>(std::int64_t{rows});
  }
};

class PlaneSetup {
 public:
  using Value = std::int64_t;
  /// `area` is twice the signed area of the triangle (> 0). The anchor is the picture's pixel nearest to the triangle.
  PlaneSetup(const RasterVertex& v0, const RasterVertex& v1, const RasterVertex& v2, std::int64_t area,
             std::int32_t anchor_x, std::int32_t anchor_y)
      : inverse_(ScaledReciprocal::of(static_cast<std::uint64_t>(area))),
        dx1_(v0.x - v2.x),
        dy1_(v0.y - v2.y),
        dx2_(v1.x - v0.x),
        dy2_(v1.y - v0.y),
        offset_x_(anchor_x * 16 + kPixelCentre - v0.x),
        offset_y_(anchor_y * 16 + kPixelCentre - v0.y) {}

  /// `value_0` is the value at vertex 0; the differences to vertices 1 and 2 are below 2^33.
  ZSTRIP_CALLED_ON_THUMB1 Plane plane(std::int64_t value_0, std::int64_t from_0_to_1, std::int64_t from_0_to_2) const {
    // The edge function 2 -> 0 is the weight of vertex 1, and 0 -> 1 that of vertex 2. 33 + 23 bits, two terms.
    const std::int64_t along_x = from_0_to_1 * dy1_ + from_0_to_2 * dy2_;
    const std::int64_t along_y = -(from_0_to_1 * dx1_ + from_0_to_2 * dx2_);
    // Steps a pixel with 8 more fraction bits than the value; 4 of the 12 are for sub-pixels. From here on modulo 2^64.
    const auto step_x = static_cast<std::uint64_t>(inverse_.quotient(along_x, 12));
    const auto step_y = static_cast<std::uint64_t>(inverse_.quotient(along_y, 12));
    const std::uint64_t to_anchor = step_x * static_cast<std::uint64_t>(std::int64_t{offset_x_}) +
                                    step_y * static_cast<std::uint64_t>(std::int64_t{offset_y_});
    // 12 bits: 8 extra, 4 sub-pixel; steps are rounded to nearest.
    return {static_cast<std::uint32_t>(static_cast<std::uint64_t>(value_0) + (to_anchor >> 12)),
            static_cast<std::uint32_t>((step_x + 128) >> 8), static_cast<std::uint32_t>((step_y + 128) >> 8)};
  }

  /// Returns a wide plane. Its error is at most the reciprocal's relative error, 2^-28 of the differences.
  WidePlane wide_plane(std::int64_t value_0, std::int64_t from_0_to_1, std::int64_t from_0_to_2) const {
    const std::int64_t along_x = from_0_to_1 * dy1_ + from_0_to_2 * dy2_;
    const std::int64_t along_y = -(from_0_to_1 * dx1_ + from_0_to_2 * dx2_);
    // With kWideBits more than in plane(); a quotient has only 30 of these 32 bits.
    const std::uint64_t step_x = static_cast<std::uint64_t>(inverse_.quotient(along_x, 30)) << 2;
    const std::uint64_t step_y = static_cast<std::uint64_t>(inverse_.quotient(along_y, 30)) << 2;
    const std::uint64_t to_anchor = step_x * static_cast<std::uint64_t>(std::int64_t{offset_x_}) +
                                    step_y * static_cast<std::uint64_t>(std::int64_t{offset_y_});
    return {(static_cast<std::uint64_t>(value_0) << kWideBits) + (to_anchor >> 12), (step_x + 128) >> 8,
            (step_y + 128) >> 8};
  }

 private:
  ScaledReciprocal inverse_;
  std::int32_t dx1_, dy1_, dx2_, dy2_;
  std::int32_t offset_x_, offset_y_;
};

}  // namespace zstrip::detail
