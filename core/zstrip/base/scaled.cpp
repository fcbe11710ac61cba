// Arithmetic of numbers of any magnitude; see scaled.hpp.
#include "zstrip/base/scaled.hpp"

#include <bit>

#include "zstrip/base/math.hpp"

namespace zstrip {

Scaled::Scaled(std::int64_t value, std::int32_t exponent) {
  const std::uint64_t magnitude =
      value < 0 ? ~static_cast<std::uint64_t>(value) + 1 : static_cast<std::uint64_t>(value);
  if (magnitude == 0) return;
  const int shift = 33 - std::countl_zero(magnitude);
  const auto top = static_cast<std::int32_t>(shift > 0 ? magnitude >> shift : magnitude << -shift);
  mantissa_ = value < 0 ? -top : top;
  exponent_ = exponent + shift;
}

std::int64_t Scaled::fixed(std::int32_t fraction_bits) const {
  const std::int32_t shift = exponent_ + fraction_bits;
  if (shift <= 0 || mantissa_ == 0) return mantissa_ >> (shift > -32 && shift <= 0 ? -shift : 31);
  constexpr std::int64_t kMax = std::int64_t{1} << 62;
  if (shift > 31) return mantissa_ > 0 ? kMax : -kMax;
  return std::int64_t{mantissa_} * (std::int64_t{1} << shift);
}

Scaled operator*(const Scaled& a, const Scaled& b) {
  return {std::int64_t{a.mantissa_} * b.mantissa_, a.exponent_ + b.exponent_};
}

Scaled operator+(const Scaled& a, const Scaled& b) {
  if (a.mantissa_ == 0) return b;
  if (b.mantissa_ == 0) return a;
  const Scaled& larger = a.exponent_ >= b.exponent_ ? a : b;
  const Scaled& smaller = a.exponent_ >= b.exponent_ ? b : a;
  constexpr int kExtra = 30;
  constexpr std::int64_t kShifted = std::int64_t{1} << kExtra;
  const std::int32_t distance = larger.exponent_ - smaller.exponent_;
  const std::int64_t small = (smaller.mantissa_ * kShifted) >> (distance < 63 ? distance : 63);
  return {larger.mantissa_ * kShifted + small, larger.exponent_ - kExtra};
}

Scaled operator/(const Scaled& a, const Scaled& b) {
  return {std::int64_t{a.mantissa_} * (std::int64_t{1} << 32) / b.mantissa_, a.exponent_ - b.exponent_ - 32};
}

Scaled root(const Scaled& value) {
  if (value.mantissa_ <= 0) return {};
  const int odd = value.exponent_ & 1;
  const std::uint64_t radicand = static_cast<std::uint64_t>(value.mantissa_) << (30 + odd);  // below 2^62
  return {square_root(radicand), (value.exponent_ - odd - 30) / 2};
}

Scaled3 operator*(const Scaled& s, const Scaled3& v) { return {s * v.x, s * v.y, s * v.z}; }
Scaled3 operator+(const Scaled3& a, const Scaled3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Scaled3 operator-(const Scaled3& a, const Scaled3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Scaled dot(const Scaled3& a, const Scaled3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Scaled3 cross(const Scaled3& a, const Scaled3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace zstrip
