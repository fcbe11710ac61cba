// Converts rectangles from RGB565 to the formats of panels.
#pragma once

#include <cstddef>
#include <cstdint>

#include "zstrip/view.hpp"

namespace zstrip {

/// Writes `rows` rows of `width` pixels as `format` to `out`: bytes_per_row(width, format) bytes each, without gaps.
/// For rgb565 and rgb565_swapped `out` must be the pixels' own memory.
void convert_pixels(PixelFormat format, std::uint16_t width, std::uint16_t rows, std::uint16_t* pixels, std::byte* out);

}  // namespace zstrip
