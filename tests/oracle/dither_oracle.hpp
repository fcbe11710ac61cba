// What ordered dithering makes of a value: the definition of docs/conventions.md in real numbers, with Bayer's matrix
// built by its recursion.
#pragma once

#include <cmath>
#include <cstdint>

namespace dither_oracle {

/// The matrix of order `order`, a power of two: four of half the order, times four, plus 0, 2 / 3, 1.
inline int bayer(int x, int y, int order) {
  if (order == 1) return 0;
  const int half = order / 2;
  constexpr int kQuarter[2][2] = {{0, 2}, {3, 1}};
  return 4 * bayer(x % half, y % half, half) + kQuarter[y / half][x / half];
}

/// The level of `bits` bits that pixel (x, y) of the picture gets for a value 0..255.
inline int level(int value, int bits, int x, int y) {
  const double steps = (value - std::floor(value / std::exp2(bits))) / std::exp2(8 - bits);
  return static_cast<int>(std::floor(steps + bayer(x % 8, y % 8, 8) / 64.0));
}

inline std::uint16_t rgb565(int r, int g, int b, int x, int y) {
  return static_cast<std::uint16_t>(level(r, 5, x, y) * 2048 + level(g, 6, x, y) * 32 + level(b, 5, x, y));
}

}  // namespace dither_oracle
