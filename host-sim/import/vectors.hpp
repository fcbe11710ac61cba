// Vectors of three numbers, in double.
#pragma once

#include <algorithm>
#include <cmath>

#include "motion/affine.hpp"

namespace zstrip::sim {

inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline double length(const Vector& v) { return std::hypot(v[0], v[1], v[2]); }

/// Returns the unit vector; zeros for zeros. Scales by the largest component first: squares of tiny edges would become
/// 0.
inline Vector unit(const Vector& v) {
  const double largest = std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
  if (!(largest > 0)) return {};
  const Vector scaled{v[0] / largest, v[1] / largest, v[2] / largest};
  const double scale = length(scaled);
  return {scaled[0] / scale, scaled[1] / scale, scaled[2] / scale};
}

}  // namespace zstrip::sim
