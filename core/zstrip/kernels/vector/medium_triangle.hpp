// Triangles of some dozen pixels a side in vectors, with the depth test of z16.
#pragma once

#include <cstdint>

#include "zstrip/kernels/medium_scan.hpp"
#include "zstrip/kernels/processor.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::detail {

/// Width plus height of the bounding box, in 1/16 pixels, below which a triangle is drawn in blocks: its edge
/// functions / 16, up to 4 pixels beyond the box, have 16 bits.
inline constexpr std::int32_t kMediumExtent = 640;

/// draw_medium. False, and nothing drawn, also where there is no room for whole blocks of 4 x 2 pixels in the strip.
bool draw_medium_flat_vector(const MediumTriangle& triangle, std::uint16_t colour);
bool draw_medium_gouraud_vector(const MediumTriangle& triangle, const Colour* const (&colours)[3]);

}  // namespace zstrip::detail
