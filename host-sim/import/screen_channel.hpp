// Converts a file's colour channels to the screen's, and those to linear light.
#pragma once

#include <cstdint>

namespace zstrip::sim {

/// Converts a channel 0..1 to 0..255; clamps other values and NaN. `linear` channels get the sRGB curve.
std::uint8_t to_screen_channel(double value, bool linear);

/// Returns the linear light of a channel, 0 to 1: the inverse of to_screen_channel for linear channels.
double from_screen_channel(std::uint8_t channel);

}  // namespace zstrip::sim
