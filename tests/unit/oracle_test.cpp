// The judge is judged first: closed forms and pictures made by hand.
#include <gtest/gtest.h>

#include "triangle_oracle.hpp"

namespace {

std::string picture(const oracle::Triangle& triangle, int width, int height) {
  std::string text;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) text += triangle.covers(x, y) ? '#' : '.';
    text += '\n';
  }
  return text;
}

TEST(Oracle, RightTriangleThroughPixelCentresByHand) {
  // Corners on the centres of pixels (0,0), (4,0), (0,4): the top row and the left column belong to it, the diagonal
  // does not.
  EXPECT_EQ(picture(oracle::Triangle({{{8, 8}, {72, 8}, {8, 72}}}), 6, 6),
            "####..\n"
            "###...\n"
            "##....\n"
            "#.....\n"
            "......\n"
            "......\n");
}

TEST(Oracle, OtherWindingIsTheSameTriangle) {
  const oracle::Triangle a({{{8, 8}, {72, 8}, {8, 72}}});
  const oracle::Triangle b({{{8, 8}, {8, 72}, {72, 8}}});
  EXPECT_EQ(picture(a, 6, 6), picture(b, 6, 6));
}

TEST(Oracle, ComplementaryHalvesOfASquareCoverItOnce) {
  const oracle::Triangle upper({{{0, 0}, {64, 0}, {0, 64}}});
  const oracle::Triangle lower({{{64, 0}, {64, 64}, {0, 64}}});
  for (int y = -1; y < 6; ++y) {
    for (int x = -1; x < 6; ++x) {
      const bool in_square = x >= 0 && x < 4 && y >= 0 && y < 4;
      EXPECT_EQ(upper.covers(x, y) + lower.covers(x, y), in_square ? 1 : 0) << x << ',' << y;
    }
  }
}

TEST(Oracle, ValuesAreLinear) {
  const oracle::Triangle triangle({{{0, 0}, {160, 0}, {0, 160}}});
  // value = 2 x + 3 y in 1/16 pixels, 0 at the origin.
  const std::array<std::int64_t, 3> values{0, 320, 480};
  for (int y = 0; y < 5; ++y) {
    for (int x = 0; x < 5; ++x) {
      const auto numerator = triangle.value_times_area(x, y, values);
      EXPECT_EQ(static_cast<long long>(numerator / triangle.area()), 2 * (16 * x + 8) + 3 * (16 * y + 8));
    }
  }
}

TEST(Oracle, ZeroAreaCoversNothing) {
  const oracle::Triangle line({{{0, 0}, {80, 80}, {160, 160}}});
  for (int i = 0; i < 10; ++i) EXPECT_FALSE(line.covers(i, i));
}

}  // namespace
