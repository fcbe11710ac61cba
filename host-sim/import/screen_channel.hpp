// Converts a file's colour channels to the screen's.
#pragma once

#include <cstdint>

namespace zstrip::sim {

/// Converts a channel 0..1 to 0..255; clamps other values and NaN. `linear` channels get the sRGB curve.
std::uint8_t to_screen_channel(double value, bool linear);

}  // namespace zstrip::sim
