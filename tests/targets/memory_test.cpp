// memcpy, memmove, memset and memcmp of targets without a C library, against their definitions: every alignment and
// length around a word, and nothing beside the range is touched.
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>

extern "C" {
void* board_memcpy(void* to, const void* from, std::size_t count);
void* board_memmove(void* to, const void* from, std::size_t count);
void* board_memset(void* to, int value, std::size_t count);
int board_memcmp(const void* a, const void* b, std::size_t count);
}

namespace {

constexpr std::size_t kMax = 53;
constexpr std::size_t kOffsets = 9;
using Buffer = std::array<std::uint8_t, 72>;

/// No two bytes near each other are equal.
Buffer pattern(unsigned seed) {
  Buffer buffer{};
  for (std::size_t i = 0; i < buffer.size(); ++i) buffer[i] = static_cast<std::uint8_t>(seed + 37 * i);
  return buffer;
}

int sign(int value) { return (value > 0) - (value < 0); }

/// Two buffers, and what must be in the first one afterwards.
struct Trial {
  std::size_t to, from, count;
  alignas(8) Buffer target = pattern(1);
  alignas(8) Buffer source = pattern(2);
  Buffer expected = target;
};

template <class Check>
void for_each_trial(Check check) {
  for (std::size_t to = 0; to < kOffsets; ++to) {
    for (std::size_t from = 0; from < kOffsets; ++from) {
      for (std::size_t count = 0; count <= kMax; ++count) {
        SCOPED_TRACE(testing::Message() << "to " << to << ", from " << from << ", count " << count);
        Trial trial{to, from, count};
        check(trial);
        ASSERT_EQ(trial.target, trial.expected);
      }
    }
  }
}

TEST(TargetsMemory, Copies) {
  for_each_trial([](Trial& t) {
    for (std::size_t i = 0; i < t.count; ++i) t.expected[t.to + i] = t.source[t.from + i];
    EXPECT_EQ(board_memcpy(&t.target[t.to], &t.source[t.from], t.count), &t.target[t.to]);
  });
}

TEST(TargetsMemory, MovesWhatOverlaps) {
  for_each_trial([](Trial& t) {
    for (std::size_t i = 0; i < t.count; ++i) t.expected[t.to + i] = t.target[t.from + i];
    EXPECT_EQ(board_memmove(&t.target[t.to], &t.target[t.from], t.count), &t.target[t.to]);
  });
}

TEST(TargetsMemory, SetsTheLowByte) {
  for_each_trial([](Trial& t) {
    for (std::size_t i = 0; i < t.count; ++i) t.expected[t.to + i] = 0xA5;
    EXPECT_EQ(board_memset(&t.target[t.to], 0x7A5, t.count), &t.target[t.to]);
  });
}

TEST(TargetsMemory, ComparesAsUnsigned) {
  for_each_trial([](Trial& t) {
    for (std::size_t i = 0; i < t.count; ++i) t.source[t.from + i] = t.target[t.to + i];
    EXPECT_EQ(board_memcmp(&t.target[t.to], &t.source[t.from], t.count), 0);
    for (std::size_t i = 0; i < t.count; ++i) {
      std::uint8_t& other = t.source[t.from + i];
      other ^= 0x80U;
      const int expected = t.target[t.to + i] < other ? -1 : 1;
      EXPECT_EQ(sign(board_memcmp(&t.target[t.to], &t.source[t.from], t.count)), expected);
      other ^= 0x80U;
    }
  });
}

}  // namespace
