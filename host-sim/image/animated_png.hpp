// Several pictures as one file that plays them: an animated PNG (APNG).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace zstrip::sim {

/// Repeats the frames without end, all of them once in `milliseconds`. `frames`: at least one; PNG files of encode(),
/// all of one size and format. Programs without APNG show the first one.
std::vector<std::uint8_t> animated_png(std::span<const std::vector<std::uint8_t>> frames, std::uint32_t milliseconds);

}  // namespace zstrip::sim
