// Integer functions for work once a frame or once a vertex: sine, square root, reciprocal.
#pragma once

#include <bit>
#include <cstdint>

#include "zstrip/base/division.hpp"
#include "zstrip/base/fixed.hpp"

namespace zstrip {

/// Sine and cosine of an angle (0.16 of a full circle), in 2.30. Exact at multiples of 90 degrees; within 4 units of
/// 2^-30 at other angles.
std::int32_t sine(Angle angle);
std::int32_t cosine(Angle angle);

/// Returns floor(sqrt(value)), exact for every input.
std::uint32_t square_root(std::uint64_t value);

/// reciprocal() in words of 32 bits. With q = floor((2^32 - 1) / upper half), 2^16 < q < 2^17, q * divisor is close to
/// 2^48: the product's bits above 2^16 are the difference, modulo 2^32. Newton's step is q - q * e, with e below 2^15.
constexpr std::int32_t reciprocal_in_halves(std::uint32_t divisor) {
  const std::uint32_t q = quotient_32(divisor >> 16), q_low = q & 0xFFFF, low = divisor & 0xFFFF;
  const std::int32_t e = static_cast<std::int32_t>(q * (divisor >> 16) + low + ((q_low * low) >> 16)) >> 2;
  const std::int32_t correction = ((-static_cast<std::int32_t>(q_low) * e >> 16) - e) >> 1;
  return (static_cast<std::int32_t>(q << 13) + correction) * 2;
}

/// Returns 2^62 / divisor for a normalised divisor (2^31 <= divisor < 2^32): a result of 31 bits, 2^30 <= result <
/// 2^31, with a relative error below 2^-28. Takes one 32-bit division and one Newton step; the same bits on every
/// target.
constexpr std::int32_t reciprocal(std::uint32_t divisor) {
  if constexpr (!kMultipliesLong) return reciprocal_in_halves(divisor);
  const std::uint32_t first = quotient_32(divisor >> 16) << 14;         // 2^62 / divisor to 2^-15
  const std::uint32_t product = multiply_high(divisor, first);          // 2^30 (1 + error)
  const std::uint32_t correction = (std::uint32_t{1} << 31) - product;  // 2^30 (1 - error)
  return static_cast<std::int32_t>(multiply_high(first, correction << 1) << 1);
}

/// Computes many quotients by the same 64-bit divisor (> 0), with 31 significant bits; for set-up, not for pixels.
struct ScaledReciprocal {
  std::int32_t mantissa;  ///< reciprocal() of the normalised divisor
  int normalisation;      ///< divisor * 2^normalisation lies in 2^31..2^32 (negative for divisors of more than 32 bits)

  static constexpr ScaledReciprocal of(std::uint64_t divisor) {
    const int zeros = std::countl_zero(divisor);
    return {reciprocal(static_cast<std::uint32_t>((divisor << zeros) >> 32)), zeros - 32};
  }
  /// Returns floor(numerator / divisor * 2^fraction_bits) with the reciprocal's relative error, modulo 2^64. 0 <=
  /// fraction_bits <= 30.
  constexpr std::int64_t quotient(std::int64_t numerator, int fraction_bits) const {
    const int shift = 62 - normalisation - fraction_bits;  // 1/divisor = mantissa * 2^(normalisation - 62)
    if constexpr (kMultipliesLonger) return longer_product_right(numerator, mantissa, shift);
    // The product has up to 95 bits: high * 2^32 + low, both exact.
    const std::int64_t high = (numerator >> 32) * mantissa;
    const std::uint64_t low = (numerator & 0xFFFFFFFF) * static_cast<std::uint64_t>(mantissa);
    if (shift < 32) {
      return static_cast<std::int64_t>((static_cast<std::uint64_t>(high) << (32 - shift)) + (low >> shift));
    }
    const std::int64_t product = high + static_cast<std::int64_t>(low >> 32);
    return product >> (shift < 95 ? shift - 32 : 63);
  }
};

/// Returns floor(numerator / divisor * 2^fraction_bits), exact, modulo 2^64; 0 < divisor <= 2^54. For set-up, not for
/// pixels: it takes two divisions for each 9 bits.
constexpr std::int64_t long_quotient(std::int64_t numerator, std::int64_t divisor, int fraction_bits) {
  std::int64_t floor = numerator / divisor;
  std::int64_t remainder = numerator % divisor;
  if (remainder < 0) remainder += divisor, --floor;
  auto quotient = static_cast<std::uint64_t>(floor);
  while (fraction_bits > 0) {
    const int bits = fraction_bits < 9 ? fraction_bits : 9;
    remainder <<= bits;
    quotient = (quotient << bits) + static_cast<std::uint64_t>(remainder / divisor);
    remainder %= divisor;
    fraction_bits -= bits;
  }
  return static_cast<std::int64_t>(quotient);
}

}  // namespace zstrip
