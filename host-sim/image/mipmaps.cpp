// Sums of integers, halved level by level, so that each value is rounded only once.
#include "image/mipmaps.hpp"

#include <algorithm>
#include <array>
#include <span>

#include "image/palette.hpp"

namespace zstrip::sim {
namespace {

/// The sum of the texels that a texel of a smaller level represents.
struct Sum {
  std::array<std::uint64_t, 3> channels{}, weighted{};  ///< in steps of RGB565; `weighted` is multiplied by alpha
  std::uint64_t alpha = 0, texels = 0;

  void operator+=(const Sum& other) {
    for (std::size_t i = 0; i < 3; ++i) channels[i] += other.channels[i], weighted[i] += other.weighted[i];
    alpha += other.alpha;
    texels += other.texels;
  }
  std::uint16_t colour() const {
    const auto mean = [this](std::size_t i) {
      return alpha == 0 ? (channels[i] + texels / 2) / texels : (weighted[i] + alpha / 2) / alpha;
    };
    return static_cast<std::uint16_t>(mean(0) << 11 | mean(1) << 5 | mean(2));
  }
  std::uint8_t mean_alpha() const { return static_cast<std::uint8_t>((alpha + texels / 2) / texels); }
};

struct Level {
  std::uint32_t width, height;
  std::vector<Sum> sums;

  Level halved() const {
    Level half{std::max(1U, width / 2), std::max(1U, height / 2), {}};
    half.sums.resize(std::size_t{half.width} * half.height);
    for (std::uint32_t y = 0; y < height; ++y) {
      for (std::uint32_t x = 0; x < width; ++x) {
        half.sums[y * half.height / height * half.width + x * half.width / width] += sums[y * width + x];
      }
    }
    return half;
  }
};

/// Reads the texture's texels as they are.
class Decoder {
 public:
  explicit Decoder(const Texture& texture)
      : texture_(texture), texels_(std::size_t{1} << (texture.log2_width + texture.log2_height)) {}

  std::span<const std::uint16_t> palette() const {
    if (!has_palette(texture_.format)) return {};
    return texture_.texels.first(std::size_t{1} << index_bits(texture_.format));
  }
  Level first_level() const {
    Level level{1U << texture_.log2_width, 1U << texture_.log2_height, {}};
    for (std::size_t i = 0; i < texels_; ++i) {
      const std::uint16_t colour = colour_of(i);
      Sum sum{{colour >> 11 & 31U, colour >> 5 & 63U, colour & 31U}, {}, alpha_of(i), 1};
      for (std::size_t channel = 0; channel < 3; ++channel) sum.weighted[channel] = sum.channels[channel] * sum.alpha;
      level.sums.push_back(sum);
    }
    return level;
  }

 private:
  std::uint16_t colour_of(std::size_t i) const {
    if (!has_palette(texture_.format)) return texture_.texels[i];
    const std::size_t bits = index_bits(texture_.format), in_word = 16 / bits, entries = std::size_t{1} << bits;
    const unsigned word = texture_.texels[entries + i / in_word];
    return texture_.texels[word >> (bits * (i % in_word)) & (entries - 1)];
  }
  std::uint8_t alpha_of(std::size_t i) const {
    if (texture_.format != TextureFormat::rgb565_alpha) return 255;
    return static_cast<std::uint8_t>(texture_.texels[texels_ + i / 2] >> (8 * (i % 2)) & 0xFF);
  }

  const Texture& texture_;
  std::size_t texels_;
};

void append(const Level& level, TextureFormat format, std::span<const std::uint16_t> palette,
            std::vector<std::uint16_t>& words) {
  std::vector<std::uint8_t> packed;
  for (const Sum& sum : level.sums) {
    if (has_palette(format)) {
      packed.push_back(nearest_entry(palette, sum.colour()));
    } else {
      words.push_back(sum.colour());
      if (format == TextureFormat::rgb565_alpha) packed.push_back(sum.mean_alpha());
    }
  }
  append_packed(packed, has_palette(format) ? index_bits(format) : 8, words);
}

}  // namespace

std::uint8_t most_smaller_levels(const Texture& texture) { return std::max(texture.log2_width, texture.log2_height); }

std::vector<std::uint16_t> with_smaller_levels(const Texture& texture, std::uint8_t levels) {
  const Decoder decoder(texture);
  const std::span<const std::uint16_t> palette = decoder.palette();
  const Texture first = without_smaller_levels(texture);
  std::vector<std::uint16_t> words(first.texels.begin(), first.texels.end());
  Level level = decoder.first_level();
  for (std::uint8_t i = 0; i < levels; ++i) {
    level = level.halved();
    append(level, texture.format, palette, words);
  }
  return words;
}

Texture without_smaller_levels(const Texture& texture) {
  Texture first = texture;
  first.smaller_levels = 0;
  first.texels =
      texture.texels.first(Decoder(texture).palette().size() +
                           level_words(texture.format, std::uint32_t{texture.log2_width} + texture.log2_height));
  return first;
}

std::vector<std::size_t> level_sizes(const Texture& texture) {
  std::vector<std::size_t> sizes;
  for (std::uint8_t i = 0; i <= texture.smaller_levels; ++i) {
    const std::size_t width = std::max(1U, (1U << texture.log2_width) >> i);
    sizes.push_back(width * std::max(1U, (1U << texture.log2_height) >> i));
  }
  return sizes;
}

}  // namespace zstrip::sim
