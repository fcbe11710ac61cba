// Encodes a picture in memory as a PNG file.
#pragma once

#include <cstdint>
#include <vector>

#include "image/rgb_image.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// Writes 8-bit RGB. Fails only if libspng does (memory).
Result<std::vector<std::uint8_t>> encode_rgb_png(const RgbImage& image);

}  // namespace zstrip::sim
