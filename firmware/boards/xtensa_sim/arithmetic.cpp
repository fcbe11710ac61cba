// Multiplication and division for which the lx106 has no instructions. The compiler calls them by these names; an
// ESP8266 has them in its ROM, so that its libgcc does not.
#include <bit>
#include <cstdint>

namespace {

template <class Unsigned>
struct Division {
  Unsigned quotient, remainder;
};

/// `divisor` must not be zero.
template <class Unsigned>
Division<Unsigned> divide(Unsigned dividend, Unsigned divisor) {
  Division<Unsigned> result{0, dividend};
  const int steps = std::countl_zero(divisor) - std::countl_zero(dividend);
  if (steps < 0) return result;
  divisor <<= steps;
  for (int step = steps; step >= 0; --step, divisor >>= 1) {
    result.quotient <<= 1;
    if (result.remainder < divisor) continue;
    result.remainder -= divisor;
    result.quotient |= 1;
  }
  return result;
}

std::uint64_t magnitude(std::int64_t value) {
  return value < 0 ? -static_cast<std::uint64_t>(value) : static_cast<std::uint64_t>(value);
}
std::uint32_t magnitude(std::int32_t value) {
  return value < 0 ? -static_cast<std::uint32_t>(value) : static_cast<std::uint32_t>(value);
}

/// Multiplies 32 by 32 bits with four products of 16 bits.
std::uint64_t multiply(std::uint32_t a, std::uint32_t b) {
  const std::uint32_t a_low = a & 0xFFFFU, a_high = a >> 16, b_low = b & 0xFFFFU, b_high = b >> 16;
  const std::uint32_t low = a_low * b_low, middle = a_high * b_low + (low >> 16);
  const std::uint32_t other = a_low * b_high + (middle & 0xFFFFU);
  const std::uint32_t high = a_high * b_high + (middle >> 16) + (other >> 16);
  return std::uint64_t{high} << 32 | other << 16 | (low & 0xFFFFU);
}

}  // namespace

extern "C" {

std::int64_t __muldi3(std::int64_t a, std::int64_t b) {
  const auto x = static_cast<std::uint64_t>(a), y = static_cast<std::uint64_t>(b);
  const auto x_low = static_cast<std::uint32_t>(x), y_low = static_cast<std::uint32_t>(y);
  const auto x_high = static_cast<std::uint32_t>(x >> 32), y_high = static_cast<std::uint32_t>(y >> 32);
  const std::uint32_t crossed = x_low * y_high + x_high * y_low;
  return static_cast<std::int64_t>(multiply(x_low, y_low) + (std::uint64_t{crossed} << 32));
}

std::uint32_t __udivsi3(std::uint32_t a, std::uint32_t b) { return divide(a, b).quotient; }
std::uint32_t __umodsi3(std::uint32_t a, std::uint32_t b) { return divide(a, b).remainder; }
std::uint64_t __udivdi3(std::uint64_t a, std::uint64_t b) { return divide(a, b).quotient; }
std::uint64_t __umoddi3(std::uint64_t a, std::uint64_t b) { return divide(a, b).remainder; }

std::int32_t __divsi3(std::int32_t a, std::int32_t b) {
  const std::uint32_t quotient = divide(magnitude(a), magnitude(b)).quotient;
  return static_cast<std::int32_t>((a ^ b) < 0 ? -quotient : quotient);
}

std::int64_t __divdi3(std::int64_t a, std::int64_t b) {
  const std::uint64_t quotient = divide(magnitude(a), magnitude(b)).quotient;
  return static_cast<std::int64_t>((a ^ b) < 0 ? -quotient : quotient);
}

std::int64_t __moddi3(std::int64_t a, std::int64_t b) {
  const std::uint64_t remainder = divide(magnitude(a), magnitude(b)).remainder;
  return static_cast<std::int64_t>(a < 0 ? -remainder : remainder);
}
}
