// Converts a file's colour channels to the screen's.
#include "import/screen_channel.hpp"

#include <algorithm>
#include <cmath>

namespace zstrip::sim {

std::uint8_t to_screen_channel(double value, bool linear) {
  if (!(value > 0)) return 0;
  double clamped = std::min(value, 1.0);
  if (linear) clamped = clamped <= 0.0031308 ? 12.92 * clamped : 1.055 * std::pow(clamped, 1 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255 * clamped));
}

}  // namespace zstrip::sim
