// Sine, square root and reciprocal: every input where the domain allows, against the standard library.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "zstrip/base/math.hpp"

namespace {

using namespace zstrip;

TEST(Math, SineOfEveryAngle) {
  double worst = 0;
  for (Angle angle = 0; angle < kFullTurn; ++angle) {
    const double exact = std::sin(angle * 2 * M_PI / kFullTurn) * 1073741824.0;
    worst = std::max(worst, std::abs(exact - sine(angle)));
    ASSERT_EQ(sine(angle), -sine(-angle)) << angle;
    ASSERT_EQ(sine(angle), sine(angle + kFullTurn)) << angle;
    ASSERT_EQ(cosine(angle), sine(angle + kFullTurn / 4)) << angle;
  }
  EXPECT_LE(worst, 4.0);
  RecordProperty("worst_in_2_to_minus_30", std::to_string(worst));
}

TEST(Math, SineIsExactAtQuarterTurns) {
  EXPECT_EQ(sine(0), 0);
  EXPECT_EQ(sine(16384), 1 << 30);
  EXPECT_EQ(sine(32768), 0);
  EXPECT_EQ(sine(49152), -(1 << 30));
}

TEST(Math, SquareRootIsTheFloor) {
  const auto check = [](std::uint64_t value) {
    const unsigned __int128 root = square_root(value);
    ASSERT_LE(root * root, value);
    ASSERT_GT((root + 1) * (root + 1), value);
  };
  for (std::uint64_t value = 0; value < 70000; ++value) check(value);
  for (int bit = 0; bit < 64; ++bit) {
    const std::uint64_t value = std::uint64_t{1} << bit;
    check(value), check(value - 1), check(value + 1);
  }
  check(~std::uint64_t{0});
  std::mt19937_64 random(1);
  for (int i = 0; i < 100000; ++i) check(random());
}

TEST(Division, ByTableIsTheQuotient) {
  for (std::uint32_t d = 0x8000; d < 0x10000; ++d) {
    ASSERT_EQ(detail::quotient_32_by_table(d), 0xFFFFFFFFU / d) << d;
  }
  for (std::uint32_t d = 1; d < 0x8000; ++d) {
    ASSERT_EQ(detail::quotient_31_by_table(d), 0x7FFFFFFFU / d) << d;
  }
}

/// What processors of 32 bits do instead of their compiler's division of 64 bits.
TEST(Division, ByDigitsAndByBitsAreTheQuotient) {
  const auto check = [](std::uint64_t numerator, std::uint32_t divisor) {
    const QuotientAndRest by_digits = detail::divide_by_digits(numerator, divisor);
    ASSERT_EQ(by_digits.quotient, numerator / divisor) << numerator << " / " << divisor;
    ASSERT_EQ(by_digits.rest, numerator % divisor) << numerator << " / " << divisor;
  };
  std::mt19937_64 random(4);
  const auto any = [&random](std::uint64_t most_bits) { return random() >> (63 - random() % most_bits); };
  for (int i = 0; i < 1000000; ++i) {
    const auto divisor = static_cast<std::uint32_t>(std::max<std::uint64_t>(1, any(32)));
    const auto quotient = static_cast<std::uint32_t>(any(32));
    // Both ends of a quotient, and anything between.
    check(std::uint64_t{quotient} * divisor, divisor);
    check(std::uint64_t{quotient} * divisor + divisor - 1, divisor);
    check(std::uint64_t{quotient} * divisor + random() % divisor, divisor);
    const std::uint64_t numerator = any(64);
    const std::uint64_t wide_divisor = std::max<std::uint64_t>(1, any(64));
    ASSERT_EQ(detail::quotient_by_bits(numerator, wide_divisor), numerator / wide_divisor) << numerator;
  }
  for (const std::uint32_t divisor : {1U, 2U, 0x7FFFU, 0x8000U, 0xFFFFU, 0x10000U, 0x80000000U, 0xFFFFFFFFU}) {
    check(0, divisor), check(std::uint64_t{divisor} * 0xFFFFFFFFU + divisor - 1, divisor);
  }
}

TEST(Multiplication, InHalvesIsThatOf64Bits) {
  std::mt19937 random(7);
  constexpr std::int32_t kEdges[] = {0,      1,       -1,       0x7FFF,    -0x8000,   0x8000,
                                     0xFFFF, 0x10000, -0x10000, INT32_MAX, INT32_MIN, INT32_MIN + 1};
  const auto number = [&](int i) {
    const auto all_bits = static_cast<std::int32_t>(random());
    return i % 3 == 0 ? kEdges[random() % std::size(kEdges)] : all_bits >> random() % 32;
  };
  for (int i = 0; i < 1000000; ++i) {
    const std::int32_t a = number(i), b = number(i / 3);
    const auto ua = static_cast<std::uint32_t>(a), ub = static_cast<std::uint32_t>(b);
    const __int128 product = static_cast<__int128>(a) * b;
    ASSERT_EQ(multiply_high_in_halves(a, b), product >> 32) << a << " " << b;
    ASSERT_EQ(multiply_high_in_halves(ua, ub), static_cast<unsigned __int128>(ua) * ub >> 32) << ua << " " << ub;
    const auto half = static_cast<std::int16_t>(b);
    ASSERT_EQ(multiply_by_half_in_halves(a, half), static_cast<__int128>(a) * half >> 16) << a << " " << half;
    if constexpr (kMultipliesLonger) {
      const std::int64_t wide = std::int64_t{a} << 31 | b;
      const auto shift = static_cast<int>(random() % 128);
      ASSERT_EQ(longer_product_right(wide, b, shift),
                static_cast<std::int64_t>((static_cast<__int128>(wide) * b) >> shift))
          << wide << " " << b << " " << shift;
    }
    if (a != INT32_MIN || b != INT32_MIN) {
      ASSERT_EQ(multiply_high_rounded_in_halves(a, b), (product + (1LL << 31)) >> 32) << a << " " << b;
    }
  }
}

void expect_reciprocal(std::uint32_t divisor) {
  const std::int64_t value = reciprocal(divisor);
  ASSERT_EQ(reciprocal_in_halves(divisor), value) << divisor;
  ASSERT_GE(value, std::int64_t{1} << 30) << divisor;
  ASSERT_LT(value, std::int64_t{1} << 31) << divisor;
  const double error = static_cast<double>(value) * divisor / std::pow(2.0, 62) - 1;
  ASSERT_LT(std::abs(error), std::pow(2.0, -28)) << divisor;
}

TEST(Math, ReciprocalOfEverySixteenBitMantissa) {
  for (std::uint32_t mantissa = 0x8000; mantissa <= 0xFFFF; ++mantissa) {
    expect_reciprocal(mantissa << 16);
    expect_reciprocal((mantissa << 16) | 1);
    expect_reciprocal((mantissa << 16) | 0x8000);
    expect_reciprocal((mantissa << 16) | 0xFFFF);
  }
}

TEST(Math, ReciprocalNeverGrowsWithSixteenBitMantissas) {
  std::int32_t previous = INT32_MAX;
  for (std::uint32_t mantissa = 0x8000; mantissa <= 0xFFFF; ++mantissa) {
    const std::int32_t value = reciprocal(mantissa << 16);
    ASSERT_LE(value, previous) << mantissa;
    previous = value;
  }
}

TEST(Math, QuotientOfAnyWidth) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 200000; ++i) {
    const std::uint64_t divisor = (random() >> (random() % 62)) | 1;
    const auto numerator = static_cast<std::int64_t>(random()) >> (6 + random() % 56);
    const int bits = static_cast<int>(random() % 13);
    const long double exact = std::ldexp(static_cast<long double>(numerator) / static_cast<long double>(divisor), bits);
    if (std::abs(exact) > 4e18L) continue;
    const auto got = static_cast<long double>(ScaledReciprocal::of(divisor).quotient(numerator, bits));
    ASSERT_LE(std::abs(got - exact), 1 + std::abs(exact) * std::pow(2.0L, -27))
        << numerator << '/' << divisor << " << " << bits;
  }
}

}  // namespace
