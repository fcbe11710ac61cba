// Kernel: draws triangles of some dozen pixels a side, with one colour or with interpolated colours, instead of their
// spans.
//
// Vertices are narrow 12.4 raster coordinates and 16.16 depth codes. The first one is the highest; if several are, the
// leftmost of them. Colours are 8 bits a channel. Every implementation writes the same bits as the portable one, the
// span rasteriser (raster/span_triangle.hpp). Only for the depth test of z16, without counting.
#pragma once

#include <cstdint>

#include "zstrip/base/processor.hpp"
#include "zstrip/geometry/project.hpp"
#include "zstrip/kernels/portable/medium_triangle.hpp"
#include "zstrip/kernels/thumb/medium_triangle.hpp"
#include "zstrip/kernels/thumb1/medium_planes.hpp"
#include "zstrip/kernels/vector/medium_triangle.hpp"
#include "zstrip/pixels/medium_scan.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::detail {

/// On processors with 32-bit words the 64-bit planes take most of a triangle's time; vectors draw eight pixels at once.
/// Left out with -Os.
inline constexpr bool kHasMediumTriangles = kHasVectors || (sizeof(void*) == 4 && !kForSize);
/// True if draw_cut_medium draws triangles.
inline constexpr bool kHasCutMedium = kHasMediumTriangles && !kHasVectors;

// Row by row, with the planes and rows of this processor; the last two for draw_cut_medium.
bool draw_medium_gouraud_by_rows(const MediumTriangle& triangle, const Colour* const (&colours)[3]);
bool draw_medium_flat_by_rows(const MediumTriangle& triangle, std::uint16_t colour);
bool draw_cut_gouraud_by_rows(const MediumTriangle& triangle, const Colour* const (&colours)[3]);
bool draw_cut_flat_by_rows(const MediumTriangle& triangle, std::uint16_t colour);

/// Sets up the planes of a triangle for which fits_words is true, from the scan's area, anchor and colours. Returns
/// false if a channel is too steep.
inline bool set_up_medium(MediumScan& scan, const SnappedVertex& v0, const SnappedVertex& v1, const SnappedVertex& v2) {
  if constexpr (kHasThumb2) {
    return set_up_medium_thumb(scan, v0, v1, v2);
  } else if constexpr (kHasThumb1) {
    return set_medium_planes(scan, ThumbPlanes(v0, v1, v2, scan.area, scan.anchor_x, scan.anchor_y), v0, v1, v2);
  } else {
    return set_up_medium_portable(scan, v0, v1, v2);
  }
}

/// Draws a triangle, or returns false and leaves it to its spans. `colours`: of the vertices if `gouraud`. A triangle
/// that crosses the left or the right side of the strip is left to draw_cut_medium or to its spans.
template <bool gouraud>
bool draw_medium(const MediumTriangle& triangle, const Colour* const (&colours)[3], std::uint16_t flat_colour) {
  if constexpr (kHasVectors) {
    if constexpr (gouraud) return draw_medium_gouraud_vector(triangle, colours);
    return draw_medium_flat_vector(triangle, flat_colour);
  } else {
    if constexpr (gouraud) return draw_medium_gouraud_by_rows(triangle, colours);
    return draw_medium_flat_by_rows(triangle, flat_colour);
  }
}

/// Draws one that draw_medium leaves, or returns false, too. Worth its code where strips are narrow.
template <bool gouraud>
bool draw_cut_medium(const MediumTriangle& triangle, const Colour* const (&colours)[3], std::uint16_t flat_colour) {
  if constexpr (!kHasCutMedium) return false;
  if constexpr (gouraud) return draw_cut_gouraud_by_rows(triangle, colours);
  return draw_cut_flat_by_rows(triangle, flat_colour);
}

}  // namespace zstrip::detail
