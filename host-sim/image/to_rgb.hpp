// The renderer's pixels with 8 bits a channel.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "image/rgb_image.hpp"
#include "zstrip/view.hpp"

namespace zstrip::sim {

/// Whether the pixels have no colour: gray4 and mono.
bool is_grey(PixelFormat format);

/// `pixels` are all rows of the view, bytes_per_row each. The largest value of a channel becomes 255.
RgbImage rgb_image_of(const View& view, std::span<const std::byte> pixels);
/// One byte a pixel, of views in gray4 or mono.
std::vector<std::uint8_t> grey_pixels_of(const View& view, std::span<const std::byte> pixels);

}  // namespace zstrip::sim
