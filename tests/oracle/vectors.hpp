// Points and directions in double precision, for oracles.
#pragma once

#include <array>
#include <cmath>

#include "zstrip/base/fixed.hpp"

namespace oracle {

using Point = std::array<double, 3>;
inline Point operator+(const Point& a, const Point& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Point operator-(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Point operator*(double s, const Point& p) { return {s * p[0], s * p[1], s * p[2]}; }
inline double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double length(const Point& p) { return std::sqrt(dot(p, p)); }
inline Point unit(const Point& p) { return 1 / length(p) * p; }

/// Q2.30, as the axes of a camera are.
inline Point of_axis(const zstrip::Vec3& v) {
  return {std::ldexp(v.x, -30), std::ldexp(v.y, -30), std::ldexp(v.z, -30)};
}
/// Q16.16, as places in the world are.
inline Point of_place(const zstrip::Vec3& v) {
  return {std::ldexp(v.x, -16), std::ldexp(v.y, -16), std::ldexp(v.z, -16)};
}
/// Returns Q16.16, to the nearest.
inline zstrip::Fixed to_fixed(double value) { return static_cast<zstrip::Fixed>(std::lround(std::ldexp(value, 16))); }

}  // namespace oracle
