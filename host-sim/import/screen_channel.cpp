// The curve of sRGB and its inverse.
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

double from_screen_channel(std::uint8_t channel) {
  const double value = channel / 255.0;
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

}  // namespace zstrip::sim
