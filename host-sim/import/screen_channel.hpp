// From a file's channels of colours to those of the screen.
#pragma once

#include <cstdint>

namespace zstrip::sim {

/// A channel 0..1 as 0..255, out-of-range and NaN clamped; `linear` channels get the sRGB curve.
std::uint8_t to_screen_channel(double value, bool linear);

}  // namespace zstrip::sim
