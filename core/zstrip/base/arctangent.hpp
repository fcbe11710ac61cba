// The angle of a direction, for pixel loops: without a division.
#pragma once

#include <bit>
#include <cstdint>

#include "zstrip/base/division.hpp"
#include "zstrip/base/fixed.hpp"

namespace zstrip {
namespace detail {

/// Returns smaller / larger in 0.15, within 2 units. 0 <= smaller <= larger, 0 < larger < 2^16.
constexpr std::int32_t ratio(std::uint32_t smaller, std::uint32_t larger) {
  const int shift = std::countl_zero(larger) - 16;
  const std::uint32_t inverse = quotient_or_one_less(larger << shift) >> 2;  // 2^30 / larger
  return static_cast<std::int32_t>(((smaller << shift) * inverse) >> 15);
}

/// Returns the angle of a tangent (0.15, 0..1) in 0.18 of a full circle: an odd polynomial of degree 9, which is within
/// 10^-5 radians.
constexpr std::int32_t eighth_arctangent(std::int32_t tangent) {
  const std::int32_t square = (tangent * tangent) >> 15;  // 0.15
  std::int32_t sum = 869;                                 // 0.18, the coefficient of tangent^9
  for (const std::int32_t coefficient : {-3552, 7516, -13781, 41716}) sum = ((sum * square) >> 15) + coefficient;
  return (sum * tangent) >> 15;
}

}  // namespace detail

/// Returns the angle from the x axis to (x, y), 0.16 of a full circle (only the low 16 bits count), within 2 units; 0
/// for (0, 0). |x|, |y| < 2^16.
constexpr Angle arctangent(std::int32_t y, std::int32_t x) {
  const auto width = static_cast<std::uint32_t>(x < 0 ? -x : x);
  const auto height = static_cast<std::uint32_t>(y < 0 ? -y : y);
  if ((width | height) == 0) return 0;
  const bool steep = height > width;
  std::int32_t angle = detail::eighth_arctangent(steep ? detail::ratio(width, height) : detail::ratio(height, width));
  if (steep) angle = (1 << 16) - angle;  // 90 degrees, 0.18
  if (x < 0) angle = (1 << 17) - angle;
  if (y < 0) angle = -angle;
  return (angle + 2) >> 2;
}

}  // namespace zstrip
