// Unit vectors in 2.30, for set-up once an instance or a frame.
#pragma once

#include <bit>
#include <cstdint>

#include "zstrip/base/fixed.hpp"
#include "zstrip/base/math.hpp"

namespace zstrip::detail {

/// A vector of any scale.
struct Wide3 {
  std::int64_t x, y, z;
  friend constexpr bool operator==(const Wide3&, const Wide3&) = default;
};

constexpr std::int64_t magnitude(std::int64_t value) { return value < 0 ? -value : value; }

/// The unit vector along `v`, in 2.30. `v` must not be zero; any scale.
inline Vec3 unit(Wide3 v) {
  const auto largest = static_cast<std::uint64_t>(magnitude(v.x) | magnitude(v.y) | magnitude(v.z));
  // Bring the largest component to 30 bits, so that the sum of squares fits 62.
  const int shift = 34 - std::countl_zero(largest);
  const auto scaled = [shift](std::int64_t c) {
    return shift >= 0 ? c >> shift : static_cast<std::int64_t>(static_cast<std::uint64_t>(c) << -shift);
  };
  v = {scaled(v.x), scaled(v.y), scaled(v.z)};
  const std::int64_t length = square_root(static_cast<std::uint64_t>(v.x * v.x + v.y * v.y + v.z * v.z));
  const auto component = [length](std::int64_t c) { return static_cast<std::int32_t>((c << 30) / length); };  // 2.30
  return {component(v.x), component(v.y), component(v.z)};
}

/// a x b of two 2.30 vectors, in 2.60 >> 8: room for the sum.
inline Wide3 cross(const Vec3& a, const Vec3& b) {
  const auto term = [](std::int32_t p, std::int32_t q, std::int32_t r, std::int32_t s) {
    return ((std::int64_t{p} * q) >> 8) - ((std::int64_t{r} * s) >> 8);
  };
  return {term(a.y, b.z, a.z, b.y), term(a.z, b.x, a.x, b.z), term(a.x, b.y, a.y, b.x)};
}

/// Whether every component is smaller in magnitude than `limit`.
constexpr bool is_within(const Wide3& v, std::int64_t limit) {
  return magnitude(v.x) < limit && magnitude(v.y) < limit && magnitude(v.z) < limit;
}

}  // namespace zstrip::detail
