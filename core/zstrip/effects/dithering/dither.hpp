// Dithering without triangles: of pixels on their way to formats with fewer bits, and of backgrounds.
#pragma once

#include <cstdint>

#include "zstrip/scene.hpp"
#include "zstrip/view.hpp"

namespace zstrip {

/// Before convert_pixels: changes the rectangle's pixels, which have no gaps, to those of which `format` loses nothing,
/// dithered (docs/conventions.md, "Dithering"). `area` is where they lie in the picture: rectangles that were drawn one
/// by one meet without a seam. Does nothing for a format that has no fewer bits than RGB565.
void dither_pixels(PixelFormat format, const Rect& area, std::uint16_t* pixels);

namespace detail {

/// Fills the rectangle, which has no gaps, with a colour as it is dithered in `area` of the picture.
void fill_dithered(const Rect& area, const Colour& colour, std::uint16_t* pixels);

}  // namespace detail
}  // namespace zstrip
