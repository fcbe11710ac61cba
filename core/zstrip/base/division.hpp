// The two quotients that are needed for each vertex and each triangle, also where there is no instruction for them.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

namespace zstrip {

/// Whether the processor divides. Without (Cortex-M0, ARM926) the compiler calls a function of 130 instructions.
#if (defined(__arm__) && !defined(__ARM_FEATURE_IDIV)) || (defined(__riscv) && !defined(__riscv_div))
inline constexpr bool kDivides = false;
#else
inline constexpr bool kDivides = true;
#endif

namespace detail {

/// 2^31 / d for d from 2^15 on in steps of 2^7, at the middle of each step: off by 2^-9 of itself at most.
inline constexpr auto kReciprocalTable = [] {
  std::array<std::uint16_t, 256> table{};
  for (std::uint32_t i = 0; i < table.size(); ++i) {
    const std::uint32_t middle = 0x8000 + i * 128 + 64;
    table[i] = static_cast<std::uint16_t>(((std::uint32_t{1} << 31) + middle / 2) / middle);
  }
  return table;
}();

/// floor(2^32 / d) or one less, for 2^15 <= d < 2^16: the table's value and one Newton step.
constexpr std::uint32_t quotient_or_one_less(std::uint32_t d) {
  const std::uint32_t first = kReciprocalTable[(d >> 7) - 256];
  const auto error = static_cast<std::int32_t>((std::uint32_t{1} << 31) - d * first);  // 2^31 * 2^-9 at most
  return 2 * first + static_cast<std::uint32_t>(((error >> 7) * static_cast<std::int32_t>(first)) >> 23);
}

/// floor((2^32 - 1) / d), without a division.
constexpr std::uint32_t quotient_32_by_table(std::uint32_t d) {
  const std::uint32_t q = quotient_or_one_less(d);
  return 0xFFFFFFFFU - q * d >= d ? q + 1 : q;
}
/// floor((2^31 - 1) / d), without a division.
constexpr std::uint32_t quotient_31_by_table(std::uint32_t d) {
  const int shift = std::countl_zero(d) - 16;  // 1 .. 15
  const std::uint32_t coarse = quotient_or_one_less(d << shift);
  // From below, off by 2^-14 at most; what is left by the same reciprocal is off by one at most.
  std::uint32_t q = (coarse - 1) << (shift - 1);
  q += ((0x7FFFFFFFU - q * d) * (coarse >> 2)) >> (30 - shift);
  return 0x7FFFFFFFU - q * d >= d ? q + 1 : q;
}

}  // namespace detail

/// floor((2^32 - 1) / divisor) for 2^15 <= divisor < 2^16.
constexpr std::uint32_t quotient_32(std::uint32_t divisor) {
  if constexpr (!kDivides) return detail::quotient_32_by_table(divisor);
  return 0xFFFFFFFFU / divisor;
}
/// floor((2^31 - 1) / divisor) for 0 < divisor < 2^15.
constexpr std::uint32_t quotient_31(std::uint32_t divisor) {
  if constexpr (!kDivides) return detail::quotient_31_by_table(divisor);
  return 0x7FFFFFFFU / divisor;
}

/// numerator / divisor, for divisor > 0. For what is divided once a frame or a light of an instance: where there is no
/// instruction for it, the compiler's own division of 64 bits takes 700 bytes.
[[gnu::noinline]] constexpr std::uint64_t seldom_quotient(std::uint64_t numerator, std::uint64_t divisor) {
  if constexpr (sizeof(void*) == sizeof(std::uint64_t)) return numerator / divisor;
  std::uint64_t quotient = 0;
  std::uint64_t rest = 0;
  for (int bit = 63; bit >= 0; --bit) {
    const bool is_above = (rest >> 63) != 0;  // of any divisor, once it is doubled
    rest = (rest << 1) | ((numerator >> bit) & 1);
    quotient <<= 1;
    if (is_above || rest >= divisor) rest -= divisor, quotient |= 1;
  }
  return quotient;
}

}  // namespace zstrip
