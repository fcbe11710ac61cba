// Flat triangles of some dozen pixels a side with SSE2 and the depth test of z16.
#pragma once

#include <cstdint>

#include "zstrip/kernels/processor.hpp"
#include "zstrip/raster/plane.hpp"
#include "zstrip/raster/target.hpp"

namespace zstrip::detail {

/// Width plus height of the bounding box, in 1/16 pixels, below which draw_medium_flat_sse2 draws a triangle: its edge
/// functions / 16, up to 4 pixels beyond the box, have 16 bits.
inline constexpr std::int32_t kMediumExtent = 640;

/// A triangle of the span rasteriser, narrow, counter-clockwise, by its depth plane. False, and nothing drawn, if it is
/// too large, or if there is no room.
bool draw_medium_flat_sse2(const StripTarget& target, const RasterVertex& v0, const RasterVertex& v1,
                           const RasterVertex& v2, const Plane& depth, std::int32_t anchor_x, std::int32_t anchor_y,
                           std::uint16_t colour);

}  // namespace zstrip::detail
