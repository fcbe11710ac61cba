// Square root and its reciprocal for pixel loops: a table and Newton's steps, with products of 32 bits only.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

namespace zstrip {
namespace detail {

/// 2^31 / sqrt(n) for n from 2^30 on in steps of 2^24, at the middle of each step: the relative error is at most 2^-8.
inline constexpr auto kInverseRootTable = [] {
  std::array<std::uint16_t, 192> table{};
  for (std::uint32_t i = 0; i < table.size(); ++i) {
    const std::uint64_t middle = (std::uint64_t{64 + i} << 24) + (1U << 23);
    std::uint64_t y = 0;  // the largest y with y^2 * middle <= 2^62
    for (std::uint64_t bit = 1U << 15; bit != 0; bit >>= 1) {
      if ((y + bit) * (y + bit) * (middle >> 16) <= std::uint64_t{1} << 46) y += bit;
    }
    table[i] = static_cast<std::uint16_t>(y);
  }
  return table;
}();

}  // namespace detail

/// A root, and the approximate reciprocal of the root.
struct NormalisedRoot {
  std::uint32_t root;     ///< 16.8: sqrt(n), within 2^-6 of a unit
  std::uint32_t inverse;  ///< 2^31 / sqrt(n) with a relative error of 2^-8, 2^15..2^16
};

/// Returns 2^31 / sqrt(n) with a relative error of 2^-14, from the root.
constexpr std::uint32_t refined_inverse(const NormalisedRoot& r) {
  const auto error = static_cast<std::int32_t>((std::uint32_t{1} << 31) - (r.root >> 8) * r.inverse);
  return r.inverse + static_cast<std::uint32_t>(((error >> 9) * static_cast<std::int32_t>(r.inverse >> 1)) >> 21);
}

/// Returns root and reciprocal for 2^30 <= n < 2^32.
constexpr NormalisedRoot normalised_root(std::uint32_t n) {
  const std::uint32_t inverse = detail::kInverseRootTable[(n >> 24) - 64];
  const auto squared_error = [n](std::uint32_t root) { return static_cast<std::int32_t>(n - root * root); };
  const auto at_most_16_bits = [](std::uint32_t root) { return root < 0xFFFF ? root : 0xFFFF; };
  // The relative error is 2^-8: 256 units, so that the error of the square is below 2^26.
  std::uint32_t root = at_most_16_bits(((n >> 16) * inverse) >> 15);
  // Newton: root += error / (2 root). The error is now below 3 units, and that of the square below 2^19.
  root = at_most_16_bits(
      root + static_cast<std::uint32_t>(((squared_error(root) >> 11) * static_cast<std::int32_t>(inverse)) >> 21));
  const std::int32_t fraction = ((squared_error(root) >> 4) * static_cast<std::int32_t>(inverse)) >> 20;  // 0.8
  return {(root << 8) + static_cast<std::uint32_t>(fraction), inverse};
}

/// sqrt(n) = root * 2^(8 - half_shift), with a relative error of 2^-22; n > 0.
struct WideRoot {
  std::uint32_t root;  ///< 16.8, the root of n shifted left by 2 half_shift and right by 32
  std::int32_t half_shift;
};
constexpr WideRoot wide_root(std::uint64_t n) {
  auto high = static_cast<std::uint32_t>(n >> 32);
  auto low = static_cast<std::uint32_t>(n);
  std::int32_t half_shift = 0;
  if (high == 0) high = low, low = 0, half_shift = 16;
  const int zeros = std::countl_zero(high) & ~1;
  if (zeros != 0) high = high << zeros | low >> (32 - zeros);
  return {normalised_root(high).root, half_shift + zeros / 2};
}

}  // namespace zstrip
