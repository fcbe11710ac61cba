// Numbers of any magnitude with 31 significant bits, for set-up whose values span more than a fixed point can hold.
// Integers only, so that every target gets the same bits.
#pragma once

#include <bit>
#include <cstdint>

#include "zstrip/base/math.hpp"

namespace zstrip {

/// mantissa * 2^exponent; 2^30 <= |mantissa| < 2^31, or 0. Each operation is right to 2^-29 of its result's magnitude,
/// sums to 2^-29 of the larger operand's. Exponents of products of a few lengths and their inverses stay far inside 32
/// bits.
class Scaled {
 public:
  constexpr Scaled() = default;
  /// value * 2^exponent.
  constexpr Scaled(std::int64_t value, std::int32_t exponent) {
    const std::uint64_t magnitude =
        value < 0 ? ~static_cast<std::uint64_t>(value) + 1 : static_cast<std::uint64_t>(value);
    if (magnitude == 0) return;
    const int shift = 33 - std::countl_zero(magnitude);
    const auto top = static_cast<std::int32_t>(shift > 0 ? magnitude >> shift : magnitude << -shift);
    mantissa_ = value < 0 ? -top : top;
    exponent_ = exponent + shift;
  }

  constexpr std::int32_t sign() const { return (mantissa_ > 0) - (mantissa_ < 0); }
  constexpr std::int32_t exponent() const { return exponent_; }
  /// The least n with |value| < 2^n; a very small number for 0.
  constexpr std::int32_t log2_bound() const { return mantissa_ == 0 ? -100000 : exponent_ + 31; }

  /// floor(value * 2^fraction_bits), at most 2^62 in magnitude.
  constexpr std::int64_t fixed(std::int32_t fraction_bits) const {
    const std::int32_t shift = exponent_ + fraction_bits;
    if (shift <= 0) return mantissa_ >> (shift > -32 ? -shift : 31);
    constexpr std::int64_t kLargest = std::int64_t{1} << 62;
    if (mantissa_ != 0 && shift > 31) return mantissa_ > 0 ? kLargest : -kLargest;
    return std::int64_t{mantissa_} * (std::int64_t{1} << (mantissa_ == 0 ? 0 : shift));
  }

  constexpr Scaled operator-() const {
    Scaled result = *this;
    result.mantissa_ = -mantissa_;
    return result;
  }
  constexpr Scaled magnitude() const { return mantissa_ < 0 ? -*this : *this; }
  /// * 2^places.
  constexpr Scaled shifted(std::int32_t places) const {
    Scaled result = *this;
    result.exponent_ += places;
    return result;
  }

  friend constexpr Scaled operator*(const Scaled& a, const Scaled& b) {
    return {std::int64_t{a.mantissa_} * b.mantissa_, a.exponent_ + b.exponent_};
  }
  friend constexpr Scaled operator+(const Scaled& a, const Scaled& b) {
    if (a.mantissa_ == 0) return b;
    if (b.mantissa_ == 0) return a;
    const Scaled& larger = a.exponent_ >= b.exponent_ ? a : b;
    const Scaled& smaller = a.exponent_ >= b.exponent_ ? b : a;
    constexpr int kExtra = 30;
    const std::int32_t distance = larger.exponent_ - smaller.exponent_;
    const std::int64_t small =
        (std::int64_t{smaller.mantissa_} * (std::int64_t{1} << kExtra)) >> (distance < 63 ? distance : 63);
    return {std::int64_t{larger.mantissa_} * (std::int64_t{1} << kExtra) + small, larger.exponent_ - kExtra};
  }
  friend constexpr Scaled operator-(const Scaled& a, const Scaled& b) { return a + -b; }
  /// b != 0.
  friend constexpr Scaled operator/(const Scaled& a, const Scaled& b) {
    return {std::int64_t{a.mantissa_} * (std::int64_t{1} << 32) / b.mantissa_, a.exponent_ - b.exponent_ - 32};
  }
  friend constexpr bool operator<(const Scaled& a, const Scaled& b) { return (a - b).mantissa_ < 0; }

  /// 0 for negative values.
  friend Scaled root(const Scaled& value) {
    if (value.mantissa_ <= 0) return {};
    const int odd = value.exponent_ & 1;
    const std::uint64_t radicand = static_cast<std::uint64_t>(value.mantissa_) << (30 + odd);  // below 2^62
    return {square_root(radicand), (value.exponent_ - odd - 30) / 2};
  }

 private:
  std::int32_t mantissa_ = 0;
  std::int32_t exponent_ = 0;
};

/// A vector of them.
struct Scaled3 {
  Scaled x, y, z;

  friend constexpr Scaled3 operator*(const Scaled& s, const Scaled3& v) { return {s * v.x, s * v.y, s * v.z}; }
  friend constexpr Scaled3 operator+(const Scaled3& a, const Scaled3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend constexpr Scaled3 operator-(const Scaled3& a, const Scaled3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend constexpr Scaled dot(const Scaled3& a, const Scaled3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
  friend constexpr Scaled3 cross(const Scaled3& a, const Scaled3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
};

}  // namespace zstrip
