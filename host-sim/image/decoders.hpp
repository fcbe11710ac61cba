// Decoders of single formats, which decode_image chooses from.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "image/rgb_image.hpp"
#include "result.hpp"

namespace zstrip::sim {

Failure damaged_picture(const char* kind, const char* reason);

/// Of four bytes a pixel; without alpha where no pixel has any.
RgbImage split_alpha(std::uint32_t width, std::uint32_t height, std::span<const std::uint8_t> rgba);

bool is_webp(std::span<const std::uint8_t> file);
/// By libwebp; the first frame of an animation is no picture.
Result<RgbImage> decode_webp(std::span<const std::uint8_t> file);

bool is_bitmap(std::span<const std::uint8_t> file);
/// TGA has no signature: whether the header is one that is possible.
bool is_targa(std::span<const std::uint8_t> file);
/// BMP and TGA by stb_image. `kind`: for messages.
Result<RgbImage> decode_bitmap_or_targa(std::span<const std::uint8_t> file, const char* kind);

}  // namespace zstrip::sim
