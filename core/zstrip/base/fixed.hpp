// Fixed-point types, and the exact operations that every stage uses.
#pragma once

#include <cstdint>

#include "zstrip/base/language.hpp"

namespace zstrip {

/// A length, direction or scale in 16.16.
using Fixed = std::int32_t;
inline constexpr int kFixedBits = 16;
inline constexpr Fixed kFixedOne = Fixed{1} << kFixedBits;

/// An angle, 0.16 of a full circle: 65536 is 360 degrees, only the low 16 bits count.
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

/// True if the processor multiplies 32 bits by 32 to 64. Without it (Cortex-M0) the compiler calls a function of 64 by
/// 64.
#if defined(__ARM_ARCH_6M__) || defined(__ARM_ARCH_8M_BASE__)
inline constexpr bool kMultipliesLong = false;
#else
inline constexpr bool kMultipliesLong = true;
#endif

/// Returns the upper 32 bits of a product, floor(a * b / 2^32), from the four products of halves.
constexpr std::uint32_t multiply_high_in_halves(std::uint32_t a, std::uint32_t b) {
  const std::uint32_t a_low = a & 0xFFFF, a_high = a >> 16;
  const std::uint32_t b_low = b & 0xFFFF, b_high = b >> 16;
  // Neither sum overflows: (2^16 - 1)^2 + 2 (2^16 - 1) < 2^32.
  const std::uint32_t middle = a_high * b_low + ((a_low * b_low) >> 16);
  const std::uint32_t rest = a_low * b_high + (middle & 0xFFFF);
  return a_high * b_high + (middle >> 16) + (rest >> 16);
}
constexpr std::int32_t multiply_high_in_halves(std::int32_t a, std::int32_t b) {
  const std::int32_t a_low = a & 0xFFFF, a_high = a >> 16;
  const std::int32_t b_low = b & 0xFFFF, b_high = b >> 16;
  const auto low =
      static_cast<std::int32_t>((static_cast<std::uint32_t>(a_low) * static_cast<std::uint32_t>(b_low)) >> 16);
  // Each product and its sum lie within +-2^31: 2^15 * (2^16 - 1) + 2^16 - 1 < 2^31.
  const std::int32_t middle = a_high * b_low + low;
  const std::int32_t rest = a_low * b_high + (middle & 0xFFFF);
  return a_high * b_high + (middle >> 16) + (rest >> 16);
}
constexpr std::int32_t multiply_high_rounded_in_halves(std::int32_t a, std::int32_t b) {
  // The lower word is at least half a unit if its highest bit is set; then the result is rounded up.
  const std::uint32_t low = static_cast<std::uint32_t>(a) * static_cast<std::uint32_t>(b);
  return multiply_high_in_halves(a, b) + static_cast<std::int32_t>(low >> 31);
}
constexpr std::int32_t multiply_by_half_in_halves(std::int32_t a, std::int16_t b) {
  // Exact in 32 bits: the low half is below 2^16, |b| <= 2^15.
  return (a >> 16) * b + (((a & 0xFFFF) * b) >> 16);
}

/// Returns the upper 32 bits of a product: floor(a * b / 2^32).
constexpr std::int32_t multiply_high(std::int32_t a, std::int32_t b) {
  if constexpr (!kMultipliesLong) return multiply_high_in_halves(a, b);
  return static_cast<std::int32_t>((std::int64_t{a} * b) >> 32);
}
constexpr std::uint32_t multiply_high(std::uint32_t a, std::uint32_t b) {
  if constexpr (!kMultipliesLong) return multiply_high_in_halves(a, b);
  return static_cast<std::uint32_t>((std::uint64_t{a} * b) >> 32);
}
/// Returns all 64 bits of the product.
constexpr std::uint64_t long_product(std::uint32_t a, std::uint32_t b) {
  if constexpr (!kMultipliesLong) return (std::uint64_t{multiply_high_in_halves(a, b)} << 32) | (a * b);
  return std::uint64_t{a} * b;
}
constexpr std::int64_t long_product(std::int32_t a, std::int32_t b) {
  if constexpr (!kMultipliesLong) {
    const auto low = static_cast<std::uint32_t>(a) * static_cast<std::uint32_t>(b);
    return static_cast<std::int64_t>((std::uint64_t{static_cast<std::uint32_t>(multiply_high_in_halves(a, b))} << 32) |
                                     low);
  }
  return std::int64_t{a} * b;
}
constexpr std::int64_t long_product(std::int64_t a, std::int64_t b) { return a * b; }
// WebAssembly has the type, too, but calls functions for it.
#if defined(__SIZEOF_INT128__) && __SIZEOF_POINTER__ == 8
inline constexpr bool kMultipliesLonger = true;  ///< true if the processor multiplies 64 bits by 64 to 128
/// Returns floor(a * b / 2^shift) modulo 2^64, 0 <= shift < 128.
constexpr std::int64_t longer_product_right(std::int64_t a, std::int64_t b, int shift) {
  __extension__ using Product = __int128;
  return static_cast<std::int64_t>((Product{a} * b) >> shift);
}
#else
inline constexpr bool kMultipliesLonger = false;
std::int64_t longer_product_right(std::int64_t a, std::int64_t b, int shift);  ///< not defined
#endif
/// Returns floor(value / 2^shift), 0 <= shift < 32, for results that fit in a word. The compiler would otherwise emit a
/// shift of two words by any number of bits.
constexpr std::int32_t shifted_to_word(std::int64_t value, int shift) {
  if constexpr (sizeof(void*) == 8) return static_cast<std::int32_t>(value >> shift);
  const auto high = static_cast<std::uint32_t>(value >> 32);
  return static_cast<std::int32_t>((high << 1 << (31 - shift)) | (static_cast<std::uint32_t>(value) >> shift));
}
/// Returns a * b / 2^32, rounded to nearest, halves up. |a * b| < 2^62.
constexpr std::int32_t multiply_high_rounded(std::int32_t a, std::int32_t b) {
  if constexpr (!kMultipliesLong) return multiply_high_rounded_in_halves(a, b);
  return static_cast<std::int32_t>((std::int64_t{a} * b + (std::int64_t{1} << 31)) >> 32);
}
/// Returns floor(a * b / 2^16) for a factor of 16 bits.
constexpr std::int32_t multiply_by_half(std::int32_t a, std::int16_t b) {
  if constexpr (!kMultipliesLong) return multiply_by_half_in_halves(a, b);
  // If a register holds the whole product, the second factor need not be shifted first.
  if constexpr (sizeof(void*) == 8) return static_cast<std::int32_t>((std::int64_t{a} * b) >> 16);
  return multiply_high(a, std::int32_t{b} << 16);
}

/// Returns `value`, but hides from the compiler that it is not negative. GCC would otherwise multiply it as an unsigned
/// word and correct the sign: three instructions instead of one on a Cortex-M3.
inline std::int32_t of_any_sign(std::int32_t value) {
  asm("" : "+r"(value));
  return value;
}

/// Returns a * b in 16.16, rounded down. The caller guarantees that the result fits.
constexpr Fixed fixed_multiply(Fixed a, Fixed b) { return static_cast<Fixed>((std::int64_t{a} * b) >> kFixedBits); }

/// Converts a compile-time constant, rounded to nearest; never evaluated at run time.
consteval Fixed fixed(double value) { return static_cast<Fixed>(value * kFixedOne + (value < 0 ? -0.5 : 0.5)); }

}  // namespace zstrip
