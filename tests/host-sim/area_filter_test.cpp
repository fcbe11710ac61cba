// Shrunk pictures against sums over a grid so fine that each of its cells lies in one texel of both pictures.
#include "import/area_filter.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace zstrip::sim::test {
namespace {

RgbImage noise(std::uint32_t width, std::uint32_t height, bool has_alpha) {
  std::mt19937 random(width * 31 + height);
  RgbImage image{width, height, {}};
  for (std::uint32_t i = 0; i < 3 * width * height; ++i) image.rgb.push_back(static_cast<std::uint8_t>(random()));
  for (std::uint32_t i = 0; has_alpha && i < width * height; ++i) {
    image.alpha.push_back(random() % 3 == 0 ? 0 : static_cast<std::uint8_t>(random()));
  }
  return image;
}

/// The definition of sRGB (IEC 61966-2-1).
double light_of(int channel) {
  const double c = channel / 255.0;
  return c > 0.04045 ? std::pow((c + 0.055) / 1.055, 2.4) : c / 12.92;
}
double channel_of(double light) {
  return 255 * (light > 0.0031308 ? 1.055 * std::pow(light, 1 / 2.4) - 0.055 : 12.92 * light);
}

void expect_means_of_areas(const RgbImage& from, std::uint32_t width, std::uint32_t height) {
  const RgbImage to = shrink(from, width, height);
  ASSERT_EQ(to.rgb.size(), 3 * std::size_t{width} * height);
  ASSERT_EQ(to.alpha.size(), from.alpha.empty() ? 0 : std::size_t{width} * height);
  for (std::uint32_t y = 0; y < height; ++y) {
    for (std::uint32_t x = 0; x < width; ++x) {
      double light[3]{}, plain[3]{}, alpha = 0;
      for (std::uint32_t v = y * from.height; v < (y + 1) * from.height; ++v) {
        for (std::uint32_t u = x * from.width; u < (x + 1) * from.width; ++u) {
          const std::size_t texel = std::size_t{v / height} * from.width + u / width;
          const double a = from.alpha.empty() ? 1 : from.alpha[texel] / 255.0;
          alpha += a;
          for (int c = 0; c < 3; ++c) {
            light[c] += a * light_of(from.rgb[3 * texel + static_cast<std::size_t>(c)]);
            plain[c] += light_of(from.rgb[3 * texel + static_cast<std::size_t>(c)]);
          }
        }
      }
      const double cells = static_cast<double>(from.width) * from.height;
      const std::size_t texel = std::size_t{y} * width + x;
      for (int c = 0; c < 3; ++c) {
        const double expected = channel_of(alpha > 0 ? light[c] / alpha : plain[c] / cells);
        EXPECT_NEAR(to.rgb[3 * texel + static_cast<std::size_t>(c)], expected, 0.500001) << x << ',' << y;
      }
      if (from.alpha.empty()) continue;
      EXPECT_NEAR(to.alpha[texel], 255 * alpha / cells, 0.500001) << x << ',' << y;
    }
  }
}

TEST(AreaFilter, EachTexelIsTheMeanLightOfItsArea) {
  for (const bool has_alpha : {false, true}) {
    expect_means_of_areas(noise(8, 8, has_alpha), 4, 2);
    expect_means_of_areas(noise(12, 7, has_alpha), 8, 4);
    expect_means_of_areas(noise(31, 17, has_alpha), 4, 16);
    expect_means_of_areas(noise(5, 1, has_alpha), 2, 1);
    expect_means_of_areas(noise(9, 9, has_alpha), 1, 1);
  }
}

TEST(AreaFilter, TheSameSidesAreTheSamePicture) {
  const RgbImage image = noise(16, 3, false);
  EXPECT_EQ(shrink(image, 16, 3).rgb, image.rgb);
}

TEST(AreaFilter, TransparentTexelsDoNotBleedTheirColour) {
  const RgbImage leaf{2, 1, {0, 200, 0, 255, 0, 255}, {255, 0}};
  const RgbImage small = shrink(leaf, 1, 1);
  EXPECT_EQ(small.rgb, (std::vector<std::uint8_t>{0, 200, 0}));
  EXPECT_EQ(small.alpha, (std::vector<std::uint8_t>{128}));
}

TEST(AreaFilter, BlackAndWhiteGiveTheGreyThatIsHalfAsBright) {
  EXPECT_EQ(shrink({2, 1, {0, 0, 0, 255, 255, 255}}, 1, 1).rgb, (std::vector<std::uint8_t>{188, 188, 188}));
}

}  // namespace
}  // namespace zstrip::sim::test
