// Unit vectors for pixel loops: as unit_vector.hpp, but the root comes from a table and Newton's steps, without a loop
// or a division.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "zstrip/base/pixel_root.hpp"
#include "zstrip/base/unit_vector.hpp"

namespace zstrip::detail {

/// direction_of for pixels: components within +-2^31. Each component of the unit vector has an error below 2^-12.5, its
/// length an error below 2^-13; `root` and `inverse` have a relative error below 2^-13.
constexpr DirectionAndLength pixel_direction_of(std::int32_t x, std::int32_t y, std::int32_t z) {
  const auto magnitude = [](std::int32_t v) {
    return v < 0 ? 0U - static_cast<std::uint32_t>(v) : static_cast<std::uint32_t>(v);
  };
  const std::uint32_t largest = magnitude(x) | magnitude(y) | magnitude(z);
  if (largest == 0) return {{0, 0, 0}, 1U << 14, 1U << 16, -31};
  const std::int32_t shift = 18 - std::countl_zero(largest);  // to 14 bits, rounded to nearest
  const auto scaled = [shift](std::int32_t v) {
    return shift > 0 ? ((v >> (shift - 1)) + 1) >> 1 : v * (std::int32_t{1} << -shift);
  };
  const std::int32_t sx = scaled(x), sy = scaled(y), sz = scaled(z);
  const auto square = static_cast<std::uint32_t>(sx * sx + sy * sy + sz * sz);  // 2^26 .. 3 2^28
  const int zeros = std::countl_zero(square) & ~1;                              // 2 or 4
  const NormalisedRoot r = normalised_root(square << zeros);
  const auto inverse = static_cast<std::int32_t>(refined_inverse(r));  // 2^15 .. 2^16
  const int drop = 17 - zeros / 2;
  const auto unit = [&](std::int32_t v) { return (v * inverse + (1 << (drop - 1))) >> drop; };  // 1.14
  return {{unit(sx), unit(sy), unit(sz)}, r.root >> 8, static_cast<std::uint32_t>(inverse) >> 1, shift - zeros / 2};
}

}  // namespace zstrip::detail
