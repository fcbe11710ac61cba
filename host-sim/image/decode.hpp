// Reads PNG, JPEG, WebP, BMP and TGA, told apart by their first bytes.
#pragma once

#include <cstdint>
#include <span>

#include "image/rgb_image.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// Largest side that is read; a hostile file must not take gigabytes.
inline constexpr std::uint32_t kMaxImageSide = 16384;

/// A damaged or truncated file is a failure whose message starts with a verb ("is not a whole PNG picture ...").
Result<RgbImage> decode_image(std::span<const std::uint8_t> file);

}  // namespace zstrip::sim
