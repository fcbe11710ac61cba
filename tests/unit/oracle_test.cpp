// The judge is judged first: closed forms and pictures made by hand.
#include <gtest/gtest.h>

#include "homogeneous_oracle.hpp"
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

using oracle::Homogeneous;
using oracle::SpaceTriangle;
using oracle::Verdict;

/// The same distance everywhere: on the screen it is the plain triangle.
SpaceTriangle facing(long double w, long double tolerance = 0) {
  return {{{{2 * w, 2 * w, w}, {2 * w, 12 * w, w}, {12 * w, 2 * w, w}}}, 1, 100, tolerance};
}

TEST(HomogeneousOracle, AFacingTriangleIsThePlainOne) {
  const oracle::Triangle plain({{{2 * 16, 2 * 16}, {2 * 16, 12 * 16}, {12 * 16, 2 * 16}}});
  for (const long double w : {1.5L, 40.0L}) {
    const SpaceTriangle space = facing(w);
    for (int y = 0; y < 16; ++y) {
      for (int x = 0; x < 16; ++x) {
        if (x + y + 1 == 14) continue;  // centres on the diagonal: the fill rule is not this oracle's
        ASSERT_EQ(space.sees(x, y) == Verdict::inside, plain.covers(x, y)) << x << ',' << y;
      }
    }
  }
}

TEST(HomogeneousOracle, AbstainsAsFarFromAnEdgeAsItIsTold) {
  const SpaceTriangle triangle = facing(2, 0.6L);
  EXPECT_EQ(triangle.sees(2, 5), Verdict::abstains) << "half a pixel inside the left edge";
  EXPECT_EQ(triangle.sees(1, 5), Verdict::abstains) << "half a pixel outside";
  EXPECT_EQ(triangle.sees(3, 5), Verdict::inside);
  EXPECT_EQ(triangle.sees(0, 5), Verdict::outside);
}

TEST(HomogeneousOracle, NearAndFarCut) {
  EXPECT_EQ(facing(0.9L).sees(4, 4), Verdict::outside);
  EXPECT_EQ(facing(101).sees(4, 4), Verdict::outside);
  EXPECT_EQ(facing(99).sees(4, 4), Verdict::inside);
}

TEST(HomogeneousOracle, AFloorFromBehindTheEyeEndsAtItsHorizon) {
  // y = 1 below the eye, from w = -10 to w = 10, 20 pixels a unit at w = 1, horizon at row 30: at w = 10 it is 2 pixels
  // below the horizon.
  const auto corner = [](long double x, long double w) { return Homogeneous{50 * w + 20 * x, 30 * w + 20, w}; };
  const SpaceTriangle ground({{corner(-1000, -10), corner(1000, -10), corner(0, 10)}}, 1, 100, 0);
  EXPECT_EQ(ground.sees(50, 20), Verdict::outside) << "sky";
  EXPECT_EQ(ground.sees(49, 31), Verdict::outside) << "beyond the tip";
  EXPECT_EQ(ground.sees(49, 33), Verdict::inside);
  EXPECT_EQ(ground.sees(49, 48), Verdict::inside);
  EXPECT_EQ(ground.sees(49, 50), Verdict::outside) << "nearer than the near plane, which is at row 50";
  EXPECT_NEAR(static_cast<double>(ground.distance(49, 39)), 20 / 9.5, 1e-9);
}

TEST(HomogeneousOracle, ValuesArePerspectiveCorrect) {
  // From w = 1 at the left to w = 3 at the right: half-way on the screen is a quarter of the way in space.
  const SpaceTriangle triangle({{{0, 0, 1}, {0, 20, 1}, {3 * 21, 0, 3}}}, 0.5L, 100, 0);
  EXPECT_NEAR(static_cast<double>(triangle.value(10, 0, {0, 0, 1})), 0.25, 1e-12);
}

}  // namespace
