// Ordered dithering: reduces the bits of a value with a threshold that depends on the pixel's position.
#pragma once

#include <cstdint>

namespace zstrip::detail {

/// Bayer's index matrix of order 8, 0..63 (B. E. Bayer, "An optimum method for two-level rendition of continuous-tone
/// pictures", IEEE International Conference on Communications, 1973): row y & 7, column x & 7 of the picture's pixel.
/// Divided by 4 it is the matrix of order 4, repeated.
inline constexpr std::uint8_t kBayer[8][8] = {{0, 32, 8, 40, 2, 34, 10, 42},  {48, 16, 56, 24, 50, 18, 58, 26},
                                              {12, 44, 4, 36, 14, 46, 6, 38}, {60, 28, 52, 20, 62, 30, 54, 22},
                                              {3, 35, 11, 43, 1, 33, 9, 41},  {51, 19, 59, 27, 49, 17, 57, 25},
                                              {15, 47, 7, 39, 13, 45, 5, 37}, {63, 31, 55, 23, 61, 29, 53, 21}};

/// Adds `threshold`, 0..63, to the lost bits of a value of 8 bits, and returns its upper `bits` (1..7) bits. With s =
/// value - floor(value / 2^bits), the mean over all thresholds is exactly s / 2^(8 - bits); with one bit it is rounded
/// down to 1/64. 0 and 255 always remain the least and the greatest level. So does every level that was widened by
/// repeating its bits, because s is then a whole number of steps.
template <int bits>
constexpr std::uint32_t dithered(std::uint32_t value, std::uint32_t threshold) {
  constexpr int kLost = 8 - bits;
  const std::uint32_t added = kLost <= 6 ? threshold >> (6 - (kLost <= 6 ? kLost : 6)) : threshold << 1;
  return (value - (value >> bits) + added) >> kLost;
}

}  // namespace zstrip::detail
