// The integer functions that quadrics stand on, against the C library.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "zstrip/base/arctangent.hpp"
#include "zstrip/base/pixel_root.hpp"
#include "zstrip/base/scaled.hpp"

namespace {

using namespace zstrip;

TEST(PixelRoot, RootsAndInversesKeepTheirBounds) {
  std::mt19937 random(1);
  double worst_root = 0, worst_inverse = 0;
  for (std::uint64_t i = 0; i < 2'000'000; ++i) {
    // Both ends, every table step's ends, and anything between.
    const std::uint64_t step = (std::uint64_t{64 + i % 192} << 24) + (i < 192 ? 0 : i < 384 ? 0xFFFFFF : random() >> 8);
    const auto n = static_cast<std::uint32_t>(step);
    const NormalisedRoot r = normalised_root(n);
    const double root = std::sqrt(static_cast<double>(n));
    worst_root = std::max(worst_root, std::abs(r.root / 256.0 - root));
    worst_inverse = std::max(worst_inverse, std::abs(refined_inverse(r) * root / 2147483648.0 - 1));
  }
  EXPECT_LT(worst_root, 1.0 / 64);
  EXPECT_LT(worst_inverse, 1.0 / 16384);
}

TEST(PixelRoot, WideRootsOfEveryLength) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 200'000; ++i) {
    const std::uint64_t n = (random() >> (random() % 64)) | 1;
    const WideRoot r = wide_root(n);
    const long double root = std::sqrt(static_cast<long double>(n));
    EXPECT_NEAR(static_cast<double>(std::ldexp(static_cast<long double>(r.root), 8 - r.half_shift) / root), 1.0,
                std::ldexp(1.0, n >> 32 == 0 ? -15 : -21))
        << n;
  }
}

TEST(Arctangent, IsWithinTwoUnits) {
  std::mt19937 random(3);
  double worst = 0;
  for (int i = 0; i < 300'000; ++i) {
    const int bits = 1 + static_cast<int>(random() % 15);
    const auto side = [&] { return static_cast<std::int32_t>(random() % (2U << bits)) - (1 << bits); };
    const std::int32_t x = side(), y = side();
    if (x == 0 && y == 0) continue;
    const double exact = std::atan2(y, x) / (2 * std::numbers::pi) * kFullTurn;
    worst = std::max(worst, std::abs(std::remainder(arctangent(y, x) - exact, 65536.0)));
  }
  EXPECT_LT(worst, 2);
  EXPECT_EQ(arctangent(0, 0), 0);
  EXPECT_EQ(arctangent(5, 0), 16384);
}

TEST(Scaled, AgreesWithLongDoubles) {
  std::mt19937_64 random(4);
  const auto value = [](const Scaled& s) {
    // Read back through fixed(), from its own magnitude.
    const int bits = 40 - s.log2_bound();
    return s.sign() == 0 ? 0.0L : std::ldexp(static_cast<long double>(s.fixed(bits)), -bits);
  };
  for (int i = 0; i < 100'000; ++i) {
    const auto any = [&] {
      const auto integer = static_cast<std::int64_t>(random()) >> (random() % 63);
      return Scaled(integer == 0 ? 1 : integer, static_cast<int>(random() % 80) - 40);
    };
    const Scaled a = any(), b = any();
    const long double x = value(a), y = value(b);
    const auto near = [](long double got, long double exact, long double magnitude) {
      EXPECT_LE(std::abs(got - exact), magnitude * std::ldexp(1.0L, -28)) << got << ' ' << exact;
    };
    near(value(a * b), x * y, std::abs(x * y));
    near(value(a / b), x / y, std::abs(x / y));
    near(value(a + b), x + y, std::max(std::abs(x), std::abs(y)));
    near(value(a - b), x - y, std::max(std::abs(x), std::abs(y)));
    near(value(root(a.magnitude())), std::sqrt(std::abs(x)), std::sqrt(std::abs(x)));
    EXPECT_EQ(a < b, x < y);
  }
}

}  // namespace
