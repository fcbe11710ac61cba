// Sine and square root at compile time. They are consteval, so that no floating point reaches a target, and do not use
// libm, so that every compiler gets the same bits (the four operations of IEEE doubles are exactly defined).
#pragma once

#include <cstdint>

#include "zstrip/base/fixed.hpp"

namespace zstrip::scenes::compile_time {

inline constexpr double kPi = 3.14159265358979323846;

/// Newton's method from above, until the value no longer falls; value >= 0.
consteval double square_root(double value) {
  if (value == 0) return 0;
  double root = value > 1 ? value : 1;
  for (;;) {
    const double next = 0.5 * (root + value / root);
    if (next >= root) return root;
    root = next;
  }
}

/// |radians| < 1000. Taylor's series within half a circle, with an error of about 1e-15.
consteval double sine(double radians) {
  while (radians > kPi) radians -= 2 * kPi;
  while (radians < -kPi) radians += 2 * kPi;
  double term = radians, sum = radians;
  for (int n = 3; n <= 35; n += 2) {
    term *= -radians * radians / (n * (n - 1));
    sum += term;
  }
  return sum;
}

consteval double cosine(double radians) { return sine(radians + kPi / 2); }

/// Rounds to the nearest integer, halves away from zero.
consteval std::int32_t nearest(double value) { return static_cast<std::int32_t>(value + (value < 0 ? -0.5 : 0.5)); }

/// Not constexpr and never defined: if the compiler would have to call it, it stops and shows this name.
void position_outside_the_half_extent();

/// Returns a coordinate of a Position, checked by the compiler.
constexpr std::int16_t grid_step(std::int64_t step) {
  if (step < -32767 || step > 32767) position_outside_the_half_extent();
  return static_cast<std::int16_t>(step);
}

}  // namespace zstrip::scenes::compile_time
