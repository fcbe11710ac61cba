// Textures that become palettes: nothing is lost where there are few colours, and what is lost otherwise is reported.
#include "image/palette.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace zstrip::sim::test {
namespace {

struct Decoded {
  std::vector<std::uint16_t> palette, texels;
};

/// From docs/formats.md.
Decoded decoded(const std::vector<std::uint16_t>& words, TextureFormat format, std::size_t texels) {
  const bool four_bits = format == TextureFormat::palette4;
  const std::size_t entries = four_bits ? 16 : 256;
  Decoded result;
  result.palette.assign(words.begin(), words.begin() + static_cast<std::ptrdiff_t>(entries));
  for (std::size_t i = 0; i < texels; ++i) {
    const unsigned word = words[entries + (four_bits ? i / 4 : i / 2)];
    result.texels.push_back(result.palette[four_bits ? word >> 4 * (i % 4) & 15 : word >> 8 * (i % 2) & 255]);
  }
  return result;
}

double channel(std::uint16_t colour, int which) {
  const int level = which == 0 ? colour >> 11 : which == 1 ? colour >> 5 & 63 : colour & 31;
  // As whole numbers of 255, the upper bits repeated.
  return which == 1 ? level << 2 | level >> 4 : level << 3 | level >> 2;
}

std::vector<std::uint16_t> texels_of(std::size_t count, std::size_t colours) {
  std::vector<std::uint16_t> texels(count);
  for (std::size_t i = 0; i < count; ++i) texels[i] = static_cast<std::uint16_t>((i * i + i / 7) % colours * 40503);
  for (std::size_t i = 0; i < colours; ++i) texels[i] = static_cast<std::uint16_t>(i * 40503);
  return texels;
}

TEST(TexelPalette, LosesNothingOfAsManyColoursAsItHas) {
  for (const auto& [format, entries, in_word] :
       {std::tuple{TextureFormat::palette4, 16U, 4U}, {TextureFormat::palette8, 256U, 2U}}) {
    for (const std::size_t colours : {std::size_t{1}, std::size_t{15}, std::size_t{entries}}) {
      for (const std::size_t count : {std::size_t{512}, std::size_t{4096}}) {
        const std::vector<std::uint16_t> texels = texels_of(count, colours);
        const IndexedTexels indexed = index_texels(texels, format);
        ASSERT_EQ(indexed.words.size(), entries + count / in_word);
        EXPECT_EQ(decoded(indexed.words, format, count).texels, texels);
        EXPECT_EQ(indexed.errors.largest, (std::array{0, 0, 0}));
        EXPECT_EQ(indexed.errors.mean, (std::array{0.0, 0.0, 0.0}));
      }
    }
  }
}

TEST(TexelPalette, TexelsThatFillNoWordHaveOneOfTheirOwn) {
  const std::vector<std::uint16_t> two{0x1234, 0xFEDC};
  EXPECT_EQ(index_texels(two, TextureFormat::palette4).words.size(), 17U);
  EXPECT_EQ(decoded(index_texels(two, TextureFormat::palette4).words, TextureFormat::palette4, 2).texels, two);
  const std::vector<std::uint16_t> one{0x1234};
  EXPECT_EQ(decoded(index_texels(one, TextureFormat::palette8).words, TextureFormat::palette8, 1).texels, one);
}

TEST(TexelPalette, ErrorsAreThoseOfTheTexels) {
  for (const auto& [format, most] : {std::pair{TextureFormat::palette4, 128.0}, {TextureFormat::palette8, 64.0}}) {
    const std::vector<std::uint16_t> texels = texels_of(4096, 3000);
    const IndexedTexels indexed = index_texels(texels, format);
    const Decoded drawn = decoded(indexed.words, format, texels.size());
    const std::set<std::uint16_t> used(drawn.texels.begin(), drawn.texels.end());
    EXPECT_GT(used.size(), drawn.palette.size() * 9 / 10);
    for (int c = 0; c < 3; ++c) {
      double largest = 0, sum = 0;
      for (std::size_t i = 0; i < texels.size(); ++i) {
        const double off = std::abs(channel(texels[i], c) - channel(drawn.texels[i], c));
        largest = std::max(largest, off);
        sum += off;
      }
      const auto at = static_cast<std::size_t>(c);
      EXPECT_EQ(indexed.errors.largest[at], largest);
      EXPECT_NEAR(indexed.errors.mean[at], sum / static_cast<double>(texels.size()), 1e-9);
      EXPECT_LT(largest, most);
      EXPECT_GT(largest, 0);
    }
  }
}

TEST(TexelPalette, TexelsGetTheNearestColour) {
  const std::vector<std::uint16_t> texels = texels_of(2048, 1500);
  const Decoded drawn =
      decoded(index_texels(texels, TextureFormat::palette4).words, TextureFormat::palette4, texels.size());
  const auto distance = [](std::uint16_t a, std::uint16_t b) {
    double sum = 0;
    for (int c = 0; c < 3; ++c) sum += std::pow(channel(a, c) - channel(b, c), 2);
    return sum;
  };
  for (std::size_t i = 0; i < texels.size(); ++i) {
    double least = 1e9;
    for (const std::uint16_t colour : drawn.palette) least = std::min(least, distance(texels[i], colour));
    ASSERT_EQ(distance(texels[i], drawn.texels[i]), least) << i;
  }
}

/// A gradient of grey has as many greys as there are entries, evenly.
TEST(TexelPalette, AGradientIsCutEvenly) {
  std::vector<std::uint16_t> texels;
  for (unsigned i = 0; i < 32; ++i) texels.insert(texels.end(), 16, static_cast<std::uint16_t>(i << 11 | i << 6 | i));
  const IndexedTexels indexed = index_texels(texels, TextureFormat::palette4);
  for (const int off : indexed.errors.largest) EXPECT_LE(off, 9);
}

}  // namespace
}  // namespace zstrip::sim::test
