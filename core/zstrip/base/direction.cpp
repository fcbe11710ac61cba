// Unit vectors and cross products.
#include "zstrip/base/direction.hpp"

#include <bit>

#include "zstrip/base/math.hpp"

namespace zstrip::detail {

Vec3 unit(Wide3 v) {
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

Wide3 cross(const Vec3& a, const Vec3& b) {
  const auto term = [](std::int32_t p, std::int32_t q, std::int32_t r, std::int32_t s) {
    return ((std::int64_t{p} * q) >> 8) - ((std::int64_t{r} * s) >> 8);
  };
  return {term(a.y, b.z, a.z, b.y), term(a.z, b.x, a.x, b.z), term(a.x, b.y, a.y, b.x)};
}

}  // namespace zstrip::detail
