// The knot with a sprite of each format and labels in both fonts over it.
#pragma once

#include <array>
#include <cstdint>

#include "zstrip/overlay.hpp"
#include "zstrip_scenes/knot.hpp"

namespace zstrip::scenes {

/// 16x16 pixels of a slope of coverage, and of colours.
template <unsigned bits>
inline constexpr auto kSlopeCoverage = [] {
  std::array<std::uint8_t, 16 * 16 * bits / 8> bytes{};
  for (unsigned i = 0; i < 256; ++i) {
    const unsigned level = (i % 16 + i / 16) * ((1U << bits) - 1) / 30, at = i * bits;
    bytes[at / 8] = static_cast<std::uint8_t>(bytes[at / 8] | level << (8 - bits - at % 8));
  }
  return bytes;
}();
inline constexpr auto kSlopeColours = [] {
  std::array<std::uint16_t, 256> colours{};
  for (unsigned i = 0; i < 256; ++i) colours[i] = static_cast<std::uint16_t>(i % 16 * 2 << 11 | i / 16 * 4 << 5 | 8);
  return colours;
}();
inline constexpr OverlayImage kSlopes[] = {{16, 16, kSlopeColours, {}},
                                           {16, 16, kSlopeColours, kSlopeCoverage<8>},
                                           {16, 16, {}, kSlopeCoverage<1>, 1},
                                           {16, 16, {}, kSlopeCoverage<4>, 4},
                                           {16, 16, {}, kSlopeCoverage<8>, 8}};
inline constexpr Sprite kSlopeSprites[] = {{2, 24, 0},
                                           {20, 24, 1},
                                           {2, 60, 2, {255, 220, 0, 255}},
                                           {20, 60, 3, {255, 60, 0, 200}},
                                           {-6, 42, 4, {0, 220, 255, 255}}};
inline constexpr Font kBothFonts[] = {kSmallFont, kLargeFont};
inline constexpr char kTitle[] = "Knot", kSubtitle[] = "2,048 triangles\nby zstrip";
inline constexpr Label kKnotLabels[] = {
    {.text = kTitle, .x = 2, .y = 2, .font = 1},
    {.text = kSubtitle, .x = 60, .y = 2, .colour = {200, 220, 255, 255}, .background = {0, 0, 0, 128}}};
inline constexpr Overlay kKnotOverlay{
    .images = kSlopes, .fonts = kBothFonts, .sprites = kSlopeSprites, .labels = kKnotLabels};

inline constexpr BuiltIn overlay = [] {
  BuiltIn scene = knot;
  scene.name = "overlay";
  scene.scene.overlay = &kKnotOverlay;
  return scene;
}();

}  // namespace zstrip::scenes
