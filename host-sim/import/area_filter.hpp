// Shrinks a picture: each texel gets the mean of the area that it covers, as light adds up.
#pragma once

#include <cstdint>

#include "image/rgb_image.hpp"

namespace zstrip::sim {

/// Returns `from` with smaller sides, 1 to those of `from`. Colours are averaged in linear light and weighted by alpha,
/// so that the colour of transparent texels does not bleed; alpha itself is averaged as it is. An area without alpha
/// gets the plain mean of its colours. Sides may also be longer than those of `from`: texels are then repeated.
RgbImage shrink(const RgbImage& from, std::uint32_t width, std::uint32_t height);

}  // namespace zstrip::sim
