// The colour of a single fragment, for effects that are computed pixel by pixel.
#pragma once

#include <cstdint>

namespace zstrip::detail {

/// A fragment's colour before it is written, 0..255 a channel.
struct FragmentColour {
  std::uint32_t r, g, b, a;
};

/// Converts RGB565 to 8 bits a channel by repeating the upper bits: 31 and 63 become 255.
constexpr FragmentColour expanded(std::uint16_t pixel) {
  const std::uint32_t r = pixel >> 11, g = (pixel >> 5) & 0x3FU, b = pixel & 0x1FU;
  return {(r << 3) | (r >> 2), (g << 2) | (g >> 4), (b << 3) | (b >> 2), 255};
}

/// Returns the mean of `a`, weighted `share` (0..256), and `b`, weighted 256 - share, rounded to nearest.
constexpr std::uint32_t mixed(std::uint32_t a, std::uint32_t b, std::uint32_t share) {
  return (a * share + b * (256 - share) + 128) >> 8;
}

}  // namespace zstrip::detail
