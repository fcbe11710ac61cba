// Unit vectors of 15 bits, for work once a vertex: 32-bit words, one root and one division.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

#include "zstrip/base/division.hpp"

namespace zstrip::detail {

/// A vector in 1.14.
struct UnitVector {
  std::int32_t x, y, z;
};

constexpr std::int32_t dot(const UnitVector& a, const UnitVector& b) {  // 3.28: below 2^30
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// An entry of a table for words from 2^30 on in steps of 2^26, at the middle of each step.
struct RootEstimate {
  std::uint16_t root;
  std::uint16_t inverse;  ///< 2^30 / root
};
inline constexpr auto kRootTable = [] {
  std::array<RootEstimate, 48> table{};
  for (std::uint32_t i = 0; i < table.size(); ++i) {
    const std::uint32_t middle = ((i + 16) << 26) + (1U << 25);
    std::uint32_t root = 1U << 15;  // rounded up; bit by bit, because every source that includes this file evaluates it
    for (std::uint32_t bit = 1U << 14; bit != 0; bit >>= 1) {
      if ((root + bit) * (root + bit) < middle) root += bit;
    }
    if (root * root < middle) ++root;
    table[i] = {static_cast<std::uint16_t>(root), static_cast<std::uint16_t>((1U << 30) / root)};
  }
  return table;
}();

/// Returns floor(sqrt(value)) of a 32-bit word: an estimate from a table, two Newton steps with its reciprocal, and a
/// correction by at most one.
template <bool counts_zeros = kCountsZeros>
constexpr std::uint32_t root_of_word(std::uint32_t value) {
  if (value == 0) return 0;
  const bool is_large = !counts_zeros && value >> 28 != 0;
  const int pairs = is_large ? (value >> 30 == 0 ? 1 : 0) : std::countl_zero(value) >> 1;
  const std::uint32_t v = value << (2 * pairs);
  const RootEstimate& estimate = kRootTable[(v >> 26) - 16];
  const auto inverse = static_cast<std::int32_t>(estimate.inverse);
  std::uint32_t root = estimate.root;
  const auto error = [&] { return static_cast<std::int32_t>(v - root * root); };
  // The error has at most 26 bits, then 20. After the first step it is at most 5, after the second below one plus the
  // rounding.
  root += static_cast<std::uint32_t>(((error() >> 10) * inverse) >> 21);
  root += static_cast<std::uint32_t>(((error() >> 5) * inverse) >> 26);
  if (root > 0xFFFF) root = 0xFFFF;
  const std::int32_t left = error();
  if (left < 0) {
    --root;
  } else if (left > static_cast<std::int32_t>(2 * root)) {
    ++root;
  }
  return root >> pairs;
}

/// Returns floor(2^30 / root) for 2^14 <= root < 2^16.
template <bool divides = kDivides>
constexpr std::uint32_t inverse_of_root(std::uint32_t root) {
  if constexpr (divides) return (1U << 30) / root;
  const std::uint32_t doublings = root < 1U << 15 ? 1 : 0;
  const std::uint32_t divisor = root << doublings;
  // This divisor is the only one whose quotients of 2^32 and of 2^32 - 1 differ.
  if (divisor == 1U << 15) return 1U << (15 + doublings);
  return quotient_32_by_table(divisor) >> (2 - doublings);
}

/// A vector as a direction and a length: |vector| = root * 2^shift.
struct DirectionAndLength {
  UnitVector unit;
  std::uint32_t root;     ///< 2^14 .. 2^16
  std::uint32_t inverse;  ///< 2^30 / root
  std::int32_t shift;
};

/// Returns direction and length of a vector with components within +-2^31. The direction of a vector of length 0 is 0.
constexpr DirectionAndLength direction_of(std::int32_t x, std::int32_t y, std::int32_t z) {
  const auto magnitude = [](std::int32_t v) {
    return v < 0 ? 0U - static_cast<std::uint32_t>(v) : static_cast<std::uint32_t>(v);
  };
  const std::uint32_t largest = magnitude(x) | magnitude(y) | magnitude(z);
  if (largest == 0) return {{0, 0, 0}, 1U << 14, 1U << 16, -31};
  const std::int32_t shift = 17 - std::countl_zero(largest);  // to 15 bits
  const auto scaled = [shift](std::int32_t v) { return shift >= 0 ? v >> shift : v * (std::int32_t{1} << -shift); };
  const std::int32_t sx = scaled(x), sy = scaled(y), sz = scaled(z);
  const std::uint32_t root =
      std::max<std::uint32_t>(root_of_word(static_cast<std::uint32_t>(sx * sx) + static_cast<std::uint32_t>(sy * sy) +
                                           static_cast<std::uint32_t>(sz * sz)),
                              1U << 14);
  const std::uint32_t inverse = inverse_of_root(root);
  const auto unit = [inverse](std::int32_t v) { return (v * static_cast<std::int32_t>(inverse)) >> 16; };  // 1.14
  return {{unit(sx), unit(sy), unit(sz)}, root, inverse, shift};
}

}  // namespace zstrip::detail
