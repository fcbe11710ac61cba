// Draws triangles of some dozen pixels a side in vectors, with the depth test of z16.
#pragma once

#include <cstdint>

#include "zstrip/base/processor.hpp"
#include "zstrip/pixels/medium_scan.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::detail {

/// Limit of the width plus height of the bounding box, in 1/16 pixels, for drawing in blocks: below it, edge functions
/// / 16 have 16 bits up to 4 pixels beyond the box.
inline constexpr std::int32_t kMediumExtent = 640;

/// These implement draw_medium. They also return false if the strip has no room for blocks of 4 x 2 pixels.
bool draw_medium_flat_vector(const MediumTriangle& triangle, std::uint16_t colour);
bool draw_medium_gouraud_vector(const MediumTriangle& triangle, const Colour* const (&colours)[3]);

}  // namespace zstrip::detail
