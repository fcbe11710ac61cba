// Fixed-point types and the few exact operations that every stage uses.
#pragma once

#include <cstdint>

namespace zstrip {

/// A length, direction or scale in 16.16.
using Fixed = std::int32_t;
inline constexpr int kFixedBits = 16;
inline constexpr Fixed kFixedOne = Fixed{1} << kFixedBits;

/// An angle in turns, 0.16: 65536 is a full turn, only the low 16 bits count.
using Angle = std::int32_t;
inline constexpr Angle kFullTurn = 65536;

struct Vec3 {
  std::int32_t x, y, z;
  friend constexpr bool operator==(const Vec3&, const Vec3&) = default;
};

/// Rows of a 3x4 matrix in 16.16; column 3 is the translation. Maps p to rows * (p, 1).
struct Transform {
  Fixed m[3][4];
  static constexpr Transform identity() { return {{{kFixedOne, 0, 0, 0}, {0, kFixedOne, 0, 0}, {0, 0, kFixedOne, 0}}}; }
};

/// Upper 32 bits of a product: floor(a * b / 2^32).
constexpr std::int32_t multiply_high(std::int32_t a, std::int32_t b) {
  return static_cast<std::int32_t>((std::int64_t{a} * b) >> 32);
}
constexpr std::uint32_t multiply_high(std::uint32_t a, std::uint32_t b) {
  return static_cast<std::uint32_t>((std::uint64_t{a} * b) >> 32);
}

/// a * b in 16.16, rounded down. The caller guarantees that the result fits.
constexpr Fixed fixed_multiply(Fixed a, Fixed b) { return static_cast<Fixed>((std::int64_t{a} * b) >> kFixedBits); }

/// Converts a compile-time constant, rounded to nearest; never evaluated at run time.
consteval Fixed fixed(double value) { return static_cast<Fixed>(value * kFixedOne + (value < 0 ? -0.5 : 0.5)); }

}  // namespace zstrip
