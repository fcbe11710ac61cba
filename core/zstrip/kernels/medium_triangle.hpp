// Kernel: triangles of some dozen pixels a side, of one colour or of interpolated ones, instead of their spans.
//
// Vertices are narrow 12.4 raster coordinates and 16.16 depth codes, the first one the highest, then the leftmost;
// colours are 8 bits a channel. An implementation writes what the span rasteriser (raster/span_triangle.hpp), which is
// the portable one, writes, bit by bit. With the depth test of z16 and nothing to count.
#pragma once

#include <cstdint>

#include "zstrip/geometry/project.hpp"
#include "zstrip/kernels/medium_scan.hpp"
#include "zstrip/kernels/portable/medium_triangle.hpp"
#include "zstrip/kernels/processor.hpp"
#include "zstrip/kernels/thumb/medium_triangle.hpp"
#include "zstrip/kernels/thumb1/medium_planes.hpp"
#include "zstrip/kernels/vector/medium_triangle.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::detail {

/// Where words have 32 bits a plane of 64 is what a triangle takes longest for; vectors have eight pixels at once. Not
/// for the least flash.
inline constexpr bool kHasMediumTriangles = kHasVectors || (sizeof(void*) == 4 && !kForSize);

/// The planes of a triangle that fits_words, by the scan's area, anchor and colours. False: a channel is too steep.
inline bool set_up_medium(MediumScan& scan, const SnappedVertex& v0, const SnappedVertex& v1, const SnappedVertex& v2) {
  if constexpr (kHasThumb2) {
    return set_up_medium_thumb(scan, v0, v1, v2);
  } else if constexpr (kHasThumb1) {
    return set_medium_planes(scan, ThumbPlanes(v0, v1, v2, scan.area, scan.anchor_x, scan.anchor_y), v0, v1, v2);
  } else {
    return set_up_medium_portable(scan, v0, v1, v2);
  }
}

/// Draws a triangle, or returns false: it is left to its spans. `colours` of the three vertices where `gouraud`.
template <bool gouraud>
bool draw_medium(const MediumTriangle& triangle, const Colour* const (&colours)[3], std::uint16_t flat_colour) {
  if constexpr (kHasVectors) {
    if constexpr (gouraud) return draw_medium_gouraud_vector(triangle, colours);
    return draw_medium_flat_vector(triangle, flat_colour);
  } else {
    if constexpr (gouraud) return draw_medium_gouraud_portable(triangle, colours);
    return draw_medium_flat_portable(triangle, flat_colour);
  }
}

}  // namespace zstrip::detail
