// Sine and square root; see math.hpp.
#include "zstrip/base/math.hpp"

namespace zstrip {
namespace {

/// Returns sin(t * 90 degrees) for t in 0..1 as 2.30: the odd Taylor polynomial to degree 13 (remainder below 2^-30).
constexpr std::int64_t quarter_sine(std::int64_t t) {
  constexpr std::int64_t kCoefficients[] = {
      // 2.30 of (pi/2)^k / k!, alternating, k = 13, 11, .., 1
      61, -3864, 172272, -5026995, 85569306, -693598668, 1686629713,
  };
  const std::int64_t square = (t * t) >> 30;  // 2.30
  std::int64_t sum = 0;                       // 2.30
  for (const std::int64_t coefficient : kCoefficients) sum = ((sum * square) >> 30) + coefficient;
  return (sum * t + (std::int64_t{1} << 29)) >> 30;
}

}  // namespace

std::int32_t sine(Angle angle) {
  const std::uint32_t turn = static_cast<std::uint32_t>(angle) & 0xFFFFU;
  const std::uint32_t half = turn & 0x7FFFU;
  const std::uint32_t quarter = half <= 0x4000U ? half : 0x8000U - half;
  constexpr std::int64_t kOne = std::int64_t{1} << 30;
  std::int64_t value = quarter_sine(std::int64_t{quarter} << 16);
  if (value > kOne || quarter == 0x4000U) value = kOne;
  return static_cast<std::int32_t>(turn < 0x8000U ? value : -value);
}

std::int32_t cosine(Angle angle) {
  return sine(static_cast<Angle>(static_cast<std::uint32_t>(angle) + static_cast<std::uint32_t>(kFullTurn / 4)));
}

std::uint32_t square_root(std::uint64_t value) {
  std::uint64_t root = 0;
  for (std::uint64_t bit = std::uint64_t{1} << 62; bit != 0; bit >>= 2) {
    if (value >= root + bit) {
      value -= root + bit;
      root = (root >> 1) + bit;
    } else {
      root >>= 1;
    }
  }
  return static_cast<std::uint32_t>(root);
}

}  // namespace zstrip
