// Reads PNG, JPEG, WebP, BMP and TGA, distinguished by their first bytes.
#pragma once

#include <cstdint>
#include <span>

#include "image/rgb_image.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// Limits of pictures: a hostile file must not take gigabytes or minutes.
inline constexpr std::uint32_t kMaxImageSide = 16384, kMaxImagePixels = 8192 * 8192;

/// Fails if a picture is too large to be read. The message starts with a verb.
Result<Done> check_image_size(std::uint32_t width, std::uint32_t height);

/// Fails for a damaged or truncated file, with a message that starts with a verb ("is not a whole PNG picture ...").
Result<RgbImage> decode_image(std::span<const std::uint8_t> file);

}  // namespace zstrip::sim
