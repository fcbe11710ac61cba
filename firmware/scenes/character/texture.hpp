// The character's texture, computed at compile time: shirt, head, sleeve and arm, trousers and shoes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "zstrip_scenes/character.hpp"

namespace zstrip::scenes::character_shape {

constexpr std::uint16_t texel(unsigned r, unsigned g, unsigned b) {
  return static_cast<std::uint16_t>(r >> 3 << 11 | g >> 2 << 5 | b >> 3);
}

inline constexpr std::uint16_t kSkinTexel = texel(226, 172, 138), kHair = texel(92, 58, 36),
                               kShirtLight = texel(236, 232, 220), kShirtDark = texel(196, 52, 48),
                               kBelt = texel(70, 44, 28), kTrousers = texel(58, 82, 138), kSeam = texel(44, 62, 108),
                               kShoe = texel(120, 72, 40), kSole = texel(40, 36, 34), kWhite = texel(248, 248, 248),
                               kPupil = texel(36, 44, 60), kMouth = texel(170, 72, 66);

// x 0..31 goes around from the back, with 15 and 16 in front; y 0..31 goes from top to bottom.
constexpr std::uint16_t shirt(std::size_t x, std::size_t y) {
  if (y >= 27) return x % 8 == 0 ? kSeam : kTrousers;
  if (y >= 25) return x == 15 || x == 16 ? kWhite : kBelt;
  return y % 6 < 3 ? kShirtLight : kShirtDark;
}
constexpr std::uint16_t head(std::size_t x, std::size_t y) {
  const std::size_t from_front = x < 16 ? 15 - x : x - 16;
  if (y < 7 || (y < 16 && from_front > 8)) return y % 3 == 0 && x % 4 == 0 ? kBelt : kHair;
  if (y == 9 && from_front >= 2 && from_front <= 5) return kHair;
  if ((y == 11 || y == 12) && from_front >= 2 && from_front <= 4) return from_front == 3 ? kPupil : kWhite;
  if (y == 19 && from_front <= 3) return kMouth;
  if (y == 15 && from_front == 0) return texel(200, 140, 110);
  return kSkinTexel;
}
constexpr std::uint16_t sleeve(std::size_t /*x*/, std::size_t y) {
  if (y < 14) return y % 6 < 3 ? kShirtLight : kShirtDark;
  return kSkinTexel;
}
constexpr std::uint16_t leg(std::size_t x, std::size_t y) {
  if (y < 24) return x == 8 || x == 24 ? kSeam : kTrousers;
  return x < 6 || x > 25 ? kSole : (y % 2 == 0 && x > 12 && x < 19 && y < 29) ? kWhite : kShoe;
}

consteval std::array<std::uint16_t, kCharacterTexelCount> texels() {
  std::array<std::uint16_t, kCharacterTexelCount> result{};
  for (std::size_t i = 0; i < result.size(); ++i) {
    const std::size_t x = i % 64, y = i / 64;
    result[i] = y < 32 ? (x < 32 ? shirt(x, y) : head(x - 32, y)) : x < 32 ? sleeve(x, y - 32) : leg(x - 32, y - 32);
  }
  return result;
}

}  // namespace zstrip::scenes::character_shape
