// The loop that hands strips to a display: order, areas, buffers that are never touched while they are sent, and every
// error at every step.
#include "zstrip_hal/present.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "late_display.hpp"

namespace zstrip::hal {
namespace {

struct Buffers {
  std::array<std::byte, 4 * 3> first, second;
  explicit Buffers(bool two) : used{first, two ? std::span<std::byte>(second) : std::span<std::byte>{}} {}
  StripBuffers used;
};

constexpr StripLayout kLayout{.count = 3, .rows = 4};  // the last strip has two rows

class Present : public testing::TestWithParam<bool> {};

TEST_P(Present, EveryStripArrivesInOrder) {
  FailingStep never;
  LateDisplay display(never);
  NumberedStrips renderer{never};
  Buffers buffers(GetParam());
  EXPECT_TRUE(present(renderer, display, kLayout, buffers.used));
  EXPECT_EQ(renderer.drawn, (std::vector<std::uint16_t>{0, 1, 2}));
  EXPECT_EQ(display.areas, (std::vector<Area>{{0, 0, kWidth, 4}, {0, 4, kWidth, 4}, {0, 8, kWidth, 2}}));
  std::vector<std::byte> expected;
  for (int y = 0; y < kHeight; ++y) {
    for (int column = 0; column < kWidth / 2; ++column)
      expected.push_back(static_cast<std::byte>(y / kLayout.rows + 1));
  }
  EXPECT_EQ(display.shown, expected);
  EXPECT_FALSE(display.in_frame);
}

TEST_P(Present, StripsMaySplitColumns) {
  FailingStep never;
  LateDisplay display(never);
  NumberedStrips renderer{never};
  Buffers buffers(GetParam());
  EXPECT_TRUE(present(renderer, display, StripLayout{.count = 4, .rows = 5, .columns = 4}, buffers.used));
  EXPECT_EQ(display.areas, (std::vector<Area>{{0, 0, 4, 5}, {4, 0, 2, 5}, {0, 5, 4, 5}, {4, 5, 2, 5}}));
}

TEST_P(Present, AnErrorAtAnyStepIsReportedAndEndsTheFrame) {
  FailingStep counting;
  {
    LateDisplay display(counting);
    NumberedStrips renderer{counting};
    Buffers buffers(GetParam());
    ASSERT_TRUE(present(renderer, display, kLayout, buffers.used));
  }
  ASSERT_GT(counting.steps, 8);
  for (int at = 0; at < counting.steps; ++at) {
    FailingStep step{.at = at};
    LateDisplay display(step);
    NumberedStrips renderer{step};
    Buffers buffers(GetParam());
    const auto result = present(renderer, display, kLayout, buffers.used);
    EXPECT_FALSE(result) << "step " << at;
    EXPECT_NE(result.draw.failed, result.display == Error::timeout) << "step " << at;
    EXPECT_LT(result.strip, kLayout.count) << "step " << at;
    EXPECT_FALSE(display.in_frame) << "step " << at;
  }
}

TEST_P(Present, LayoutsThatDoNotFitAreRefused) {
  for (const StripLayout layout :
       {StripLayout{2, 4}, StripLayout{4, 4}, StripLayout{0, 4}, StripLayout{4, 0}, StripLayout{0, 0},
        StripLayout{65535, 65535}, StripLayout{3, 4, kWidth + 1}, StripLayout{3, 4, 1}}) {
    FailingStep never;
    LateDisplay display(never);
    NumberedStrips renderer{never};
    Buffers buffers(GetParam());
    EXPECT_EQ(present(renderer, display, layout, buffers.used).display, Error::strip_layout);
    EXPECT_EQ(never.steps, 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Hal, Present, testing::Bool(),
                         [](const auto& test) { return test.param ? "TwoBuffers" : "OneBuffer"; });

TEST(Hal, PresentRefusesSmallBuffers) {
  FailingStep never;
  LateDisplay display(never);
  NumberedStrips renderer{never};
  std::array<std::byte, 12> large;
  std::array<std::byte, 11> small;
  for (const StripBuffers& buffers :
       {StripBuffers{small, {}}, StripBuffers{large, small}, StripBuffers{small, large}, StripBuffers{}}) {
    EXPECT_EQ(present(renderer, display, kLayout, buffers).display, Error::pixels_too_small);
  }
  EXPECT_EQ(never.steps, 0);
}

}  // namespace
}  // namespace zstrip::hal
