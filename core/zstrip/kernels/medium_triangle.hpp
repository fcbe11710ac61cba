// Kernel: flat triangles of some dozen pixels a side, instead of their spans.
//
// Vertices are narrow 12.4 raster coordinates, depth is a plane of 16.16 codes. An implementation writes what the span
// rasteriser (raster/span_triangle.hpp), which is the portable one, writes, bit by bit. With the depth test of z16 and
// nothing to count.
#pragma once

#include <cstdint>

#include "zstrip/kernels/processor.hpp"
#include "zstrip/kernels/sse2/medium_triangle.hpp"
#include "zstrip/raster/plane.hpp"
#include "zstrip/raster/target.hpp"

namespace zstrip::detail {

/// Whether any triangle is drawn by draw_medium_flat.
inline constexpr bool kHasMediumTriangles = kHasSse2;

/// A counter-clockwise triangle. False, and nothing drawn, if it is left to its spans.
inline bool draw_medium_flat(const StripTarget& target, const RasterVertex& v0, const RasterVertex& v1,
                             const RasterVertex& v2, const Plane& depth, std::int32_t anchor_x, std::int32_t anchor_y,
                             std::uint16_t colour) {
  if constexpr (kHasSse2) {
    return draw_medium_flat_sse2(target, v0, v1, v2, depth, anchor_x, anchor_y, colour);
  } else {
    return false;
  }
}

}  // namespace zstrip::detail
