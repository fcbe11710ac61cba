// Converts the renderer's pixels to 8 bits a channel; names their formats.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "image/rgb_image.hpp"
#include "zstrip/view.hpp"

namespace zstrip::sim {

/// True if the pixels have no colour: gray4 and mono.
bool is_grey(PixelFormat format);

/// Returns the name of the enumerator: "rgb565", "gray4" ...
const char* name(PixelFormat format);

/// `pixels` are all rows of the view, bytes_per_row each. The largest value of a channel becomes 255.
RgbImage rgb_image_of(const View& view, std::span<const std::byte> pixels);
/// Returns one byte a pixel, for views in gray4 or mono.
std::vector<std::uint8_t> grey_pixels_of(const View& view, std::span<const std::byte> pixels);

}  // namespace zstrip::sim
