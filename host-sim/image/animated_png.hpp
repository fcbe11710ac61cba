// Several pictures as one file that plays them: an animated PNG (APNG).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace zstrip::sim {

/// Plays the frames for ever, all of them once in `milliseconds`. `frames`: at least one; PNG files of encode(), all of
/// one size and format. Programs that know no APNG show the first.
std::vector<std::uint8_t> animated_png(std::span<const std::vector<std::uint8_t>> frames, std::uint32_t milliseconds);

}  // namespace zstrip::sim
