// Numbers of any magnitude with 31 significant bits, for set-up whose values exceed the range of fixed point. Integers
// only, so that every target gets the same bits.
#pragma once

#include <cstdint>

namespace zstrip {

/// mantissa * 2^exponent; 2^30 <= |mantissa| < 2^31, or 0. Each operation has an error of 2^-29 of its result's
/// magnitude, sums of 2^-29 of the larger operand's. Exponents of products of a few lengths and their inverses stay far
/// inside 32 bits. Not inlined, to save flash: set-up is rare.
class Scaled {
 public:
  constexpr Scaled() = default;
  /// value * 2^exponent.
  Scaled(std::int64_t value, std::int32_t exponent);

  std::int32_t sign() const { return (mantissa_ > 0) - (mantissa_ < 0); }
  /// Returns the least n with |value| < 2^n; a very small number for 0.
  std::int32_t log2_bound() const { return mantissa_ == 0 ? -100000 : exponent_ + 31; }
  /// Returns floor(value * 2^fraction_bits), at most 2^62 in magnitude.
  std::int64_t fixed(std::int32_t fraction_bits) const;

  Scaled operator-() const { return of(-mantissa_, exponent_); }
  Scaled magnitude() const { return mantissa_ < 0 ? -*this : *this; }
  /// Returns this number * 2^places.
  Scaled shifted(std::int32_t places) const { return of(mantissa_, exponent_ + places); }

  friend Scaled operator*(const Scaled& a, const Scaled& b);
  friend Scaled operator+(const Scaled& a, const Scaled& b);
  friend Scaled operator-(const Scaled& a, const Scaled& b) { return a + -b; }
  /// b != 0.
  friend Scaled operator/(const Scaled& a, const Scaled& b);
  friend bool operator<(const Scaled& a, const Scaled& b) { return (a - b).mantissa_ < 0; }
  /// Returns the square root; 0 for negative values.
  friend Scaled root(const Scaled& value);

 private:
  static Scaled of(std::int32_t mantissa, std::int32_t exponent) {
    Scaled result;
    result.mantissa_ = mantissa;
    result.exponent_ = exponent;
    return result;
  }

  std::int32_t mantissa_ = 0;
  std::int32_t exponent_ = 0;
};

/// A vector of three such numbers.
struct Scaled3 {
  Scaled x, y, z;
};
Scaled3 operator*(const Scaled& s, const Scaled3& v);
Scaled3 operator+(const Scaled3& a, const Scaled3& b);
Scaled3 operator-(const Scaled3& a, const Scaled3& b);
Scaled dot(const Scaled3& a, const Scaled3& b);
Scaled3 cross(const Scaled3& a, const Scaled3& b);

}  // namespace zstrip
