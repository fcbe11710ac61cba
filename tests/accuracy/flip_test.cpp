// LDR-FLIP on pictures of which its value is known beforehand.
#include "accuracy/flip.hpp"

#include <gtest/gtest.h>

#include <random>

namespace zstrip::sim {
namespace {

using Picture = std::vector<std::array<float, 3>>;
constexpr std::uint32_t kSide = 48;

Picture all_of(const std::array<float, 3>& colour) { return Picture(std::size_t{kSide} * kSide, colour); }
Picture noise(std::uint32_t seed) {
  std::mt19937 random(seed);
  Picture picture = all_of({});
  for (auto& pixel : picture) {
    for (float& channel : pixel) channel = static_cast<float>(random() % 256);
  }
  return picture;
}
double mean(const std::vector<float>& values) {
  double sum = 0;
  for (const float value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

TEST(Flip, EqualPicturesDoNotDiffer) {
  for (const float value : flip(kSide, kSide, noise(1), noise(1))) EXPECT_EQ(value, 0);
}

TEST(Flip, IsSymmetricAndWithinItsBounds) {
  const Picture a = noise(1), b = noise(2);
  const std::vector<float> there = flip(kSide, kSide, a, b);
  EXPECT_EQ(there, flip(kSide, kSide, b, a));
  for (const float value : there) {
    EXPECT_GT(value, 0);
    EXPECT_LE(value, 1);
  }
}

// Pictures of one colour have no features: all is the colour difference.
TEST(Flip, GreenAndBlueAreAsFarApartAsColoursGet) {
  EXPECT_NEAR(mean(flip(kSide, kSide, all_of({0, 255, 0}), all_of({0, 0, 255}))), 1, 1e-4);
}

// |dL| is 100; green and blue are 203.3 apart; both to the power of 0.7 are 25.12 and 41.28. Above 0.4 of the latter
// 0.95 grows linearly to 1: 0.95 + 0.05 (25.12 - 16.51) / (41.28 - 16.51).
TEST(Flip, BlackAndWhite) {
  EXPECT_NEAR(mean(flip(kSide, kSide, all_of({0, 0, 0}), all_of({255, 255, 255}))), 0.9674, 2e-4);
}

// A grey of lightness 50 and one of 51.  0.95 / 16.51 * 1^0.7.
TEST(Flip, OneUnitOfLightness) {
  // 118.9 and 121.4 of 255 have L* 50 and 51.
  EXPECT_NEAR(mean(flip(kSide, kSide, all_of({118.89F, 118.89F, 118.89F}), all_of({121.38F, 121.38F, 121.38F}))),
              0.95 / 16.51, 0.002);
}

TEST(Flip, APixelIsSeenAroundItAndNotFarAway) {
  Picture dotted = all_of({128, 128, 128});
  dotted[24 * kSide + 24] = {255, 255, 255};
  const std::vector<float> seen = flip(kSide, kSide, all_of({128, 128, 128}), dotted);
  EXPECT_GT(seen[24 * kSide + 24], 0.2);
  EXPECT_GT(seen[24 * kSide + 25], 0);
  EXPECT_LT(seen[24 * kSide + 25], seen[24 * kSide + 24]);
  EXPECT_NEAR(seen[0], 0, 1e-6);
}

TEST(Flip, APatternOfPixelsIsLostFromAfar) {
  Picture board = all_of({128, 128, 128}), light = board;
  for (std::uint32_t i = 0; i < board.size(); ++i) {
    const bool even = (i / kSide + i % kSide) % 2 == 0;
    board[i] = even ? std::array<float, 3>{150, 150, 150} : std::array<float, 3>{104, 104, 104};
  }
  const double near = mean(flip(kSide, kSide, light, board, 30)), far = mean(flip(kSide, kSide, light, board, 120));
  EXPECT_GT(near, 3 * far);
}

// Beside an edge that one picture has and the other has not colours differ no more than far from it, but count more.
TEST(Flip, LostEdgesAreAmplified) {
  const Picture even = all_of({90, 90, 90});
  Picture step = even;
  for (std::uint32_t i = 0; i < step.size(); ++i) {
    if (i % kSide >= kSide / 2) step[i] = {165, 165, 165};
  }
  const std::vector<float> seen = flip(kSide, kSide, even, step);
  EXPECT_GT(seen[24 * kSide + kSide / 2 + 1], 1.05 * seen[24 * kSide + kSide - 1]);
}

}  // namespace
}  // namespace zstrip::sim
