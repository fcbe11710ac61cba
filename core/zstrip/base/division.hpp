// The two quotients that each vertex and each triangle needs, also for processors without a division instruction.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

namespace zstrip {

/// True if the processor has a division. Without it (Cortex-M0, ARM926) the compiler calls a function of 130
/// instructions.
#if (defined(__arm__) && !defined(__ARM_FEATURE_IDIV)) || (defined(__riscv) && !defined(__riscv_div))
inline constexpr bool kDivides = false;
#else
inline constexpr bool kDivides = true;
#endif

/// True if the processor counts leading zeros. Without it the compiler calls a function of 20 instructions and more.
#if (defined(__arm__) && !defined(__ARM_FEATURE_CLZ)) || (defined(__riscv) && !defined(__riscv_zbb))
inline constexpr bool kCountsZeros = false;
#else
inline constexpr bool kCountsZeros = true;
#endif

namespace detail {

/// 2^31 / d for d from 2^15 on in steps of 2^7, at the middle of each step: the relative error is at most 2^-9.
inline constexpr auto kReciprocalTable = [] {
  std::array<std::uint16_t, 256> table{};
  for (std::uint32_t i = 0; i < table.size(); ++i) {
    const std::uint32_t middle = 0x8000 + i * 128 + 64;
    table[i] = static_cast<std::uint16_t>(((std::uint32_t{1} << 31) + middle / 2) / middle);
  }
  return table;
}();

/// Returns floor(2^32 / d) or one less, for 2^15 <= d < 2^16: the table's value and one Newton step.
constexpr std::uint32_t quotient_or_one_less(std::uint32_t d) {
  const std::uint32_t first = kReciprocalTable[(d >> 7) - 256];
  const auto error = static_cast<std::int32_t>((std::uint32_t{1} << 31) - d * first);  // 2^31 * 2^-9 at most
  return 2 * first + static_cast<std::uint32_t>(((error >> 7) * static_cast<std::int32_t>(first)) >> 23);
}

/// Returns floor((2^32 - 1) / d), without a division.
constexpr std::uint32_t quotient_32_by_table(std::uint32_t d) {
  const std::uint32_t q = quotient_or_one_less(d);
  return 0xFFFFFFFFU - q * d >= d ? q + 1 : q;
}
/// Returns floor((2^31 - 1) / d), without a division.
constexpr std::uint32_t quotient_31_by_table(std::uint32_t d) {
  const int shift = std::countl_zero(d) - 16;  // 1 .. 15
  const std::uint32_t coarse = quotient_or_one_less(d << shift);
  // Too small by at most 2^-14 of itself. The rest times the same reciprocal then leaves an error of at most one.
  std::uint32_t q = (coarse - 1) << (shift - 1);
  q += ((0x7FFFFFFFU - q * d) * (coarse >> 2)) >> (30 - shift);
  return 0x7FFFFFFFU - q * d >= d ? q + 1 : q;
}

}  // namespace detail

/// Returns floor((2^32 - 1) / divisor) for 2^15 <= divisor < 2^16.
constexpr std::uint32_t quotient_32(std::uint32_t divisor) {
  if constexpr (!kDivides) return detail::quotient_32_by_table(divisor);
  return 0xFFFFFFFFU / divisor;
}
/// Returns floor((2^31 - 1) / divisor) for 0 < divisor < 2^15.
constexpr std::uint32_t quotient_31(std::uint32_t divisor) {
  if constexpr (!kDivides) return detail::quotient_31_by_table(divisor);
  return 0x7FFFFFFFU / divisor;
}

namespace detail {

/// True if the processor divides 64 bits. The compiler's own function for other processors takes 700 bytes.
inline constexpr bool kDivides64 = sizeof(void*) == sizeof(std::uint64_t);

/// seldom_quotient without a division: computes one bit of the quotient in each step.
constexpr std::uint64_t quotient_by_bits(std::uint64_t numerator, std::uint64_t divisor) {
  int bit = std::countl_zero(divisor) - std::countl_zero(numerator);  // the first bit that can be set
  if (bit < 0) return 0;
  divisor <<= bit;
  std::uint64_t quotient = 0;
  for (; bit >= 0; --bit) {
    quotient <<= 1;
    if (numerator >= divisor) numerator -= divisor, quotient |= 1;
    divisor >>= 1;
  }
  return quotient;
}

}  // namespace detail

/// Returns numerator / divisor, for divisor > 0. For rare divisions: once a frame, or once a light of an instance.
[[gnu::noinline]] constexpr std::uint64_t seldom_quotient(std::uint64_t numerator, std::uint64_t divisor) {
  if constexpr (detail::kDivides64) return numerator / divisor;
  return detail::quotient_by_bits(numerator, divisor);
}

struct QuotientAndRest {
  std::uint32_t quotient, rest;
};

namespace detail {

/// divide_long with two digits of 16 bits (Knuth, The Art of Computer Programming, volume 2, algorithm 4.3.1 D).
constexpr QuotientAndRest divide_by_digits(std::uint64_t numerator, std::uint32_t divisor) {
  const int shift = std::countl_zero(divisor);
  divisor <<= shift, numerator <<= shift;
  const std::uint32_t reciprocal = quotient_32(divisor >> 16);  // 2^32 / the divisor's upper half
  auto rest = static_cast<std::uint32_t>(numerator >> 32);
  auto low = static_cast<std::uint32_t>(numerator);
  std::uint32_t quotient = 0;
  for (int i = 0; i < 2; ++i) {
    const std::uint64_t dividend = (std::uint64_t{rest} << 16) | (low >> 16);
    // At most two too large, because the divisor's lower half is ignored; or two too small, because of the reciprocal.
    auto digit = static_cast<std::uint32_t>((std::uint64_t{rest} * reciprocal) >> 32);
    std::uint64_t product = std::uint64_t{digit} * divisor;
    while (product > dividend) product -= divisor, --digit;
    while (dividend - product >= divisor) product += divisor, ++digit;
    rest = static_cast<std::uint32_t>(dividend - product);
    low <<= 16;
    quotient = (quotient << 16) + digit;
  }
  return {quotient, rest >> shift};
}

}  // namespace detail

/// Divides, for divisor > 0 and a quotient below 2^32. For divisions once an edge.
[[gnu::noinline]] constexpr QuotientAndRest divide_long(std::uint64_t numerator, std::uint32_t divisor) {
  if constexpr (detail::kDivides64) {
    return {static_cast<std::uint32_t>(numerator / divisor), static_cast<std::uint32_t>(numerator % divisor)};
  }
  return detail::divide_by_digits(numerator, divisor);
}

}  // namespace zstrip
