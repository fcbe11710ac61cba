// Dithers without triangles: pixels before conversion to formats with fewer bits, and backgrounds.
#pragma once

#include <cstdint>

#include "zstrip/scene.hpp"
#include "zstrip/view.hpp"

namespace zstrip {

/// Call it before convert_pixels. Replaces the rectangle's pixels, which have no gaps, by dithered ones of which
/// `format` loses nothing (docs/conventions.md, "Dithering"). `area` is their position in the picture, so that
/// rectangles which were drawn separately meet without a seam. Does nothing for a format with at least the bits of
/// RGB565.
void dither_pixels(PixelFormat format, const Rect& area, std::uint16_t* pixels);

namespace detail {

/// Fills the rectangle, which has no gaps, with a colour, dithered for `area` of the picture.
void fill_dithered(const Rect& area, const Colour& colour, std::uint16_t* pixels);

}  // namespace detail
}  // namespace zstrip
