// Unit vectors of 15 bits, quick enough for work once a vertex: whole words, one root of 16 steps and one division.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

namespace zstrip::detail {

/// 1.14.
struct UnitVector {
  std::int32_t x, y, z;
};

constexpr std::int32_t dot(const UnitVector& a, const UnitVector& b) {  // 3.28: below 2^30
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// floor(sqrt(value)) of a whole word: 16 steps.
constexpr std::uint32_t root_of_word(std::uint32_t value) {
  std::uint32_t root = 0;
  for (std::uint32_t bit = 1U << 30; bit != 0; bit >>= 2) {
    const std::uint32_t trial = root + bit;
    root >>= 1;
    if (value >= trial) value -= trial, root += bit;
  }
  return root;
}

/// A vector as a direction and a length: |vector| = root * 2^shift.
struct DirectionAndLength {
  UnitVector unit;
  std::uint32_t root;     ///< 2^14 .. 2^16
  std::uint32_t inverse;  ///< 2^30 / root
  std::int32_t shift;
};

/// Components within +-2^31. The direction of no vector at all is no direction: 0.
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
  const std::uint32_t inverse = (1U << 30) / root;
  const auto unit = [inverse](std::int32_t v) { return (v * static_cast<std::int32_t>(inverse)) >> 16; };  // 1.14
  return {{unit(sx), unit(sy), unit(sz)}, root, inverse, shift};
}

}  // namespace zstrip::detail
