// Multiplication and division of processors without them, against this machine's: every pair of numbers around powers
// of two, and of many others.
#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <vector>

extern "C" {
std::int64_t board_muldi3(std::int64_t a, std::int64_t b);
std::uint32_t board_udivsi3(std::uint32_t a, std::uint32_t b);
std::uint32_t board_umodsi3(std::uint32_t a, std::uint32_t b);
std::uint64_t board_udivdi3(std::uint64_t a, std::uint64_t b);
std::uint64_t board_umoddi3(std::uint64_t a, std::uint64_t b);
std::int32_t board_divsi3(std::int32_t a, std::int32_t b);
std::int64_t board_divdi3(std::int64_t a, std::int64_t b);
std::int64_t board_moddi3(std::int64_t a, std::int64_t b);
}

namespace {

std::vector<std::uint64_t> numbers() {
  std::vector<std::uint64_t> all;
  for (int bit = 0; bit < 64; ++bit) {
    for (int around = -1; around <= 1; ++around) {
      all.push_back((std::uint64_t{1} << bit) + static_cast<std::uint64_t>(around));
      all.push_back(~all.back());
    }
  }
  std::uint64_t state = 1;
  for (int i = 0; i < 256; ++i) {
    state = state * 6364136223846793005U + 1442695040888963407U;
    all.push_back(state >> (i % 64));
  }
  return all;
}

TEST(Arithmetic, IsThatOfThisMachine) {
  const std::vector<std::uint64_t> all = numbers();
  for (const std::uint64_t a : all) {
    for (const std::uint64_t b : all) {
      const auto x = static_cast<std::int64_t>(a), y = static_cast<std::int64_t>(b);
      ASSERT_EQ(static_cast<std::uint64_t>(board_muldi3(x, y)), a * b) << a << " * " << b;
      if (b == 0) continue;
      ASSERT_EQ(board_udivdi3(a, b), a / b) << a << " / " << b;
      ASSERT_EQ(board_umoddi3(a, b), a % b) << a << " % " << b;
      if (x == std::numeric_limits<std::int64_t>::min() && y == -1) continue;
      ASSERT_EQ(board_divdi3(x, y), x / y) << x << " / " << y;
      ASSERT_EQ(board_moddi3(x, y), x % y) << x << " % " << y;
    }
  }
}

TEST(Arithmetic, Of32BitsIsThatOfThisMachine) {
  const std::vector<std::uint64_t> all = numbers();
  for (const std::uint64_t wide_a : all) {
    for (const std::uint64_t wide_b : all) {
      const auto a = static_cast<std::uint32_t>(wide_a), b = static_cast<std::uint32_t>(wide_b);
      if (b == 0) continue;
      ASSERT_EQ(board_udivsi3(a, b), a / b) << a << " / " << b;
      ASSERT_EQ(board_umodsi3(a, b), a % b) << a << " % " << b;
      const auto x = static_cast<std::int32_t>(a), y = static_cast<std::int32_t>(b);
      if (x == std::numeric_limits<std::int32_t>::min() && y == -1) continue;
      ASSERT_EQ(board_divsi3(x, y), x / y) << x << " / " << y;
    }
  }
}

}  // namespace
