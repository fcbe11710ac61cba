// Decoders of single formats, called by decode_image.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "image/rgb_image.hpp"
#include "result.hpp"

namespace zstrip::sim {

Failure damaged_picture(const char* kind, const char* reason);

/// Converts four bytes a pixel; the result has no alpha if all pixels are opaque.
RgbImage split_alpha(std::uint32_t width, std::uint32_t height, std::span<const std::uint8_t> rgba);

bool is_webp(std::span<const std::uint8_t> file);
/// Decodes with libwebp. Fails for animations.
Result<RgbImage> decode_webp(std::span<const std::uint8_t> file);

bool is_bitmap(std::span<const std::uint8_t> file);
/// True if the header can be that of a TGA file: TGA has no signature.
bool is_targa(std::span<const std::uint8_t> file);
/// Decodes BMP and TGA with stb_image. `kind`: for messages.
Result<RgbImage> decode_bitmap_or_targa(std::span<const std::uint8_t> file, const char* kind);

}  // namespace zstrip::sim
