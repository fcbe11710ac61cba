// Smaller levels of textures against means in doubles, in every format.
#include "image/mipmaps.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "image/palette.hpp"
#include "zstrip/scene/validate.hpp"

namespace zstrip::sim::test {
namespace {

struct Texel {
  std::array<double, 3> channels;  ///< 0..1
  double alpha;                    ///< 0..255
};

Texel texel_of(std::uint16_t colour, double alpha) {
  return {{(colour >> 11) / 31.0, (colour >> 5 & 63) / 63.0, (colour & 31) / 31.0}, alpha};
}

/// All levels of a texture from docs/formats.md, row by row.
std::vector<std::vector<Texel>> decoded(const Texture& texture) {
  std::vector<std::vector<Texel>> levels;
  const bool has_alpha = texture.format == TextureFormat::rgb565_alpha;
  const unsigned bits = texture.format == TextureFormat::palette4 ? 4 : 8;
  const bool indexed = texture.format == TextureFormat::palette4 || texture.format == TextureFormat::palette8;
  std::size_t at = indexed ? std::size_t{1} << bits : 0;
  for (int level = 0; level <= texture.smaller_levels; ++level) {
    const std::size_t count = static_cast<std::size_t>(std::max(1, 1 << texture.log2_width >> level)) *
                              static_cast<std::size_t>(std::max(1, 1 << texture.log2_height >> level));
    const auto packed = [&](std::size_t first, std::size_t i) {
      const std::size_t in_word = 16 / bits;
      return texture.texels[first + i / in_word] >> (bits * (i % in_word)) & ((1U << bits) - 1);
    };
    std::vector<Texel> texels;
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint16_t colour = indexed ? texture.texels[packed(at, i)] : texture.texels[at + i];
      texels.push_back(texel_of(colour, has_alpha ? packed(at + count, i) : 255));
    }
    levels.push_back(texels);
    const std::size_t packed_words = (count + 16 / bits - 1) / (16 / bits);
    at += (indexed ? 0 : count) + (indexed || has_alpha ? packed_words : 0);
  }
  EXPECT_EQ(at, texture.texels.size());
  return levels;
}

std::vector<std::uint16_t> words_of(TextureFormat format, unsigned log2_width, unsigned log2_height) {
  const Texture texture{{}, static_cast<std::uint8_t>(log2_width), static_cast<std::uint8_t>(log2_height), format};
  std::vector<std::uint16_t> words(detail::texel_words(texture));
  for (std::size_t i = 0; i < words.size(); ++i) words[i] = static_cast<std::uint16_t>(i * i * 40503 + i * 977 + 5);
  return words;
}

/// The mean over the block of the first level that a texel of a smaller one stands for.
Texel mean(const std::vector<Texel>& first, std::size_t width, std::size_t height, std::size_t column, std::size_t row,
           std::size_t columns, std::size_t rows) {
  Texel sum{{0, 0, 0}, 0}, plain{{0, 0, 0}, 0};
  const std::size_t wide = width / columns, high = height / rows;
  for (std::size_t y = row * high; y < (row + 1) * high; ++y) {
    for (std::size_t x = column * wide; x < (column + 1) * wide; ++x) {
      const Texel& texel = first[y * width + x];
      for (std::size_t c = 0; c < 3; ++c) {
        sum.channels[c] += texel.channels[c] * texel.alpha;
        plain.channels[c] += texel.channels[c];
      }
      sum.alpha += texel.alpha;
    }
  }
  const double texels = static_cast<double>(wide * high);
  for (std::size_t c = 0; c < 3; ++c) {
    sum.channels[c] = sum.alpha > 0 ? sum.channels[c] / sum.alpha : plain.channels[c] / texels;
  }
  sum.alpha /= texels;
  return sum;
}

void expect_means(TextureFormat format, unsigned log2_width, unsigned log2_height,
                  const std::vector<std::uint16_t>& words) {
  SCOPED_TRACE(testing::Message() << static_cast<int>(format) << ": " << log2_width << ", " << log2_height);
  Texture texture{words, static_cast<std::uint8_t>(log2_width), static_cast<std::uint8_t>(log2_height), format};
  const std::uint8_t levels = most_smaller_levels(texture);
  EXPECT_EQ(levels, std::max(log2_width, log2_height));
  const std::vector<std::uint16_t> all = with_smaller_levels(texture, levels);
  texture.texels = all;
  texture.smaller_levels = levels;
  EXPECT_TRUE(detail::valid_texture(texture));
  EXPECT_TRUE(std::ranges::equal(std::span(all).first(words.size()), words));
  const auto decoded_levels = decoded(texture);
  const std::size_t width = std::size_t{1} << log2_width, height = std::size_t{1} << log2_height;
  for (std::size_t level = 1; level < decoded_levels.size(); ++level) {
    const std::size_t columns = std::max<std::size_t>(1, width >> level);
    const std::size_t rows = std::max<std::size_t>(1, height >> level);
    ASSERT_EQ(decoded_levels[level].size(), columns * rows);
    for (std::size_t i = 0; i < columns * rows; ++i) {
      const Texel expected = mean(decoded_levels[0], width, height, i % columns, i / columns, columns, rows);
      const Texel& actual = decoded_levels[level][i];
      if (has_palette(format)) {
        // No entry is much nearer: the mean is rounded to RGB565 before it is compared, a channel of 31 by 1/62.
        const auto distance = [&](const Texel& other) {
          double sum = 0;
          for (std::size_t c = 0; c < 3; ++c) sum += std::pow(other.channels[c] - expected.channels[c], 2);
          return std::sqrt(sum);
        };
        for (std::size_t entry = 0; entry < std::size_t{1} << index_bits(format); ++entry) {
          EXPECT_LE(distance(actual), distance(texel_of(words[entry], 255)) + 0.06);
        }
      } else {
        for (std::size_t c = 0; c < 3; ++c) {
          EXPECT_NEAR(actual.channels[c], expected.channels[c], (c == 1 ? 0.5 / 63 : 0.5 / 31) + 1e-9);
        }
        EXPECT_NEAR(actual.alpha, expected.alpha, 0.5 + 1e-9);
      }
    }
  }
}

TEST(SmallerLevels, AreMeansOfTheFirst) {
  for (const TextureFormat format :
       {TextureFormat::rgb565, TextureFormat::rgb565_alpha, TextureFormat::palette8, TextureFormat::palette4}) {
    for (const auto& [log2_width, log2_height] : {std::pair{3U, 3U}, {4U, 1U}, {0U, 3U}, {0U, 0U}, {5U, 4U}}) {
      expect_means(format, log2_width, log2_height, words_of(format, log2_width, log2_height));
    }
  }
}

TEST(SmallerLevels, WhatIsClearHasNoColourBesideWhatIsNot) {
  // Red that is seen, green that is not; and four texels of which none is.
  std::vector<std::uint16_t> words{0xF800, 0x07E0, 0x07E0, 0x07E0, 0x00FF, 0x0000};
  expect_means(TextureFormat::rgb565_alpha, 1, 1, words);
  Texture texture{words, 1, 1, TextureFormat::rgb565_alpha};
  EXPECT_EQ(with_smaller_levels(texture, 1)[6], 0xF800);
  EXPECT_EQ(with_smaller_levels(texture, 1)[7], 64) << "a quarter of 255, to nearest";
  words[4] = 0;
  expect_means(TextureFormat::rgb565_alpha, 1, 1, words);
}

TEST(SmallerLevels, OfTheFirstLevelOnlyAreBuiltAgain) {
  const std::vector<std::uint16_t> words = words_of(TextureFormat::rgb565_alpha, 3, 2);
  Texture texture{words, 3, 2, TextureFormat::rgb565_alpha};
  const std::vector<std::uint16_t> once = with_smaller_levels(texture, 3);
  texture.texels = once;
  texture.smaller_levels = 3;
  EXPECT_EQ(with_smaller_levels(texture, 3), once);
  EXPECT_EQ(level_sizes(texture), (std::vector<std::size_t>{32, 8, 2, 1}));
  const Texture first = without_smaller_levels(texture);
  EXPECT_EQ(first.smaller_levels, 0);
  EXPECT_TRUE(std::ranges::equal(first.texels, words));
}

TEST(SmallerLevels, APaletteOfAllLevelsLosesNothing) {
  for (const TextureFormat format : {TextureFormat::palette8, TextureFormat::palette4}) {
    // Two colours, four with their means down to one texel at most.
    std::vector<std::uint16_t> texels(16);
    for (std::size_t i = 0; i < 16; ++i) texels[i] = i % 4 == 0 ? 0xF81F : 0x0000;
    Texture texture{texels, 3, 1};
    const std::vector<std::uint16_t> words = with_smaller_levels(texture, 3);
    texture.texels = words;
    texture.smaller_levels = 3;
    const IndexedTexels indexed = index_texels(words, format, level_sizes(texture));
    EXPECT_EQ(indexed.errors.largest, (std::array{0, 0, 0}));
    const Texture with_palette{indexed.words, 3, 1, format, 3};
    EXPECT_TRUE(detail::valid_texture(with_palette));
    const auto expected = decoded(texture), actual = decoded(with_palette);
    for (std::size_t level = 0; level < 4; ++level) {
      for (std::size_t i = 0; i < expected[level].size(); ++i) {
        EXPECT_EQ(actual[level][i].channels, expected[level][i].channels) << level << ' ' << i;
      }
    }
  }
}

}  // namespace
}  // namespace zstrip::sim::test
