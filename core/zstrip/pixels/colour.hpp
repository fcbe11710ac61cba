// RGB565: packs and expands channels, adds pixels, multiplies texels by light.
#pragma once

#include <cstdint>

#include "zstrip/base/bayer.hpp"
#include "zstrip/scene.hpp"

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

constexpr std::uint16_t rgb565(const Colour& c) {
  return static_cast<std::uint16_t>(((c.r & 0xF8U) << 8) | ((c.g & 0xFCU) << 3) | (c.b >> 3));
}

/// Packs channels in 8.16, 0 <= channel < 256.
constexpr std::uint16_t rgb565(std::uint32_t r, std::uint32_t g, std::uint32_t b) {
  return static_cast<std::uint16_t>(((r >> 8) & 0xF800U) | ((g >> 13) & 0x07E0U) | (b >> 19));
}

/// Packs channels of 8 bits, dithered with a threshold of kBayer.
constexpr std::uint16_t dithered_rgb565(std::uint32_t r, std::uint32_t g, std::uint32_t b, std::uint32_t threshold) {
  return static_cast<std::uint16_t>((dithered<5>(r, threshold) << 11) | (dithered<6>(g, threshold) << 5) |
                                    dithered<5>(b, threshold));
}

/// The mask for green of one pixel of a pair, and red and blue of the other. Each channel has five free bits above it,
/// for a sum of 32 pixels.
inline constexpr std::uint32_t kSpreadChannels = 0x07E0F81F;
inline constexpr std::uint32_t kOneInEach = (1U << 21) | (1U << 11) | 1U;

/// Returns a channel's start value for interpolation, 8.16. It has half a unit more, so that errors below 1/2 never
/// wrap.
constexpr std::int32_t channel_start(std::uint8_t channel) { return (channel << 16) | 0x8000; }

/// Converts a light channel in 8.16 to a factor, 0 .. 256.
constexpr std::uint32_t light_factor(std::uint32_t channel) {
  const std::uint32_t whole = channel >> 16;
  return whole + (whole >> 7);
}

/// Multiplies a texel by light factors.
constexpr std::uint16_t multiplied(std::uint16_t texel, std::uint32_t r, std::uint32_t g, std::uint32_t b) {
  // Rounds to nearest: with 5 or 6 bits, rounding down would darken a texel by half a step.
  const std::uint32_t red = ((texel >> 11) * r + 128) >> 8;
  const std::uint32_t green = (((texel >> 5) & 0x3FU) * g + 128) >> 8;
  const std::uint32_t blue = ((texel & 0x1FU) * b + 128) >> 8;
  return static_cast<std::uint16_t>((red << 11) | (green << 5) | blue);
}

/// Multiplies a texel by light channels in 8.16.
constexpr std::uint16_t modulated(std::uint16_t texel, std::uint32_t r, std::uint32_t g, std::uint32_t b) {
  return multiplied(texel, light_factor(r), light_factor(g), light_factor(b));
}

}  // namespace zstrip::detail
