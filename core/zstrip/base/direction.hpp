// Unit vectors in 2.30, for set-up once an instance or a frame. Not inlined, to save flash.
#pragma once

#include <cstdint>

#include "zstrip/base/fixed.hpp"

namespace zstrip::detail {

/// A vector of any scale.
struct Wide3 {
  std::int64_t x, y, z;
  friend constexpr bool operator==(const Wide3&, const Wide3&) = default;
};

constexpr std::int64_t magnitude(std::int64_t value) { return value < 0 ? -value : value; }

/// The unit vector along `v`, in 2.30. `v` must not be zero; any scale.
Vec3 unit(Wide3 v);

/// a x b of two 2.30 vectors, in 2.60 >> 8: room for the sum.
Wide3 cross(const Vec3& a, const Vec3& b);

/// True if every component is smaller in magnitude than `limit`.
constexpr bool is_within(const Wide3& v, std::int64_t limit) {
  return magnitude(v.x) < limit && magnitude(v.y) < limit && magnitude(v.z) < limit;
}

}  // namespace zstrip::detail
