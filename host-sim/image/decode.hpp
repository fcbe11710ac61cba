// Reads PNG, JPEG, WebP, BMP and TGA, told apart by their first bytes.
#pragma once

#include <cstdint>
#include <span>

#include "image/rgb_image.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// What is read at most; a hostile file must not take gigabytes, nor minutes.
inline constexpr std::uint32_t kMaxImageSide = 16384, kMaxImagePixels = 8192 * 8192;

/// Fails where a picture is too large to be read. The message starts with a verb.
Result<Done> check_image_size(std::uint32_t width, std::uint32_t height);

/// A damaged or truncated file is a failure whose message starts with a verb ("is not a whole PNG picture ...").
Result<RgbImage> decode_image(std::span<const std::uint8_t> file);

}  // namespace zstrip::sim
