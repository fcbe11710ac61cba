// Writes pixels as a JPEG file.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "result.hpp"

namespace zstrip::sim {

/// Takes `width` * `height` pixels, each of one byte of grey or three of red, green and blue, row by row.
Result<std::vector<std::uint8_t>> write_jpeg(std::span<const std::uint8_t> pixels, int width, int height);

}  // namespace zstrip::sim
