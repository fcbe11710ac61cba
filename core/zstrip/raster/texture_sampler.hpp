// Reads texels for fragments with effects: any level, with or without a palette, nearest or bilinear, 8 bits a channel.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "zstrip/raster/fragment_settings.hpp"
#include "zstrip/raster/textured_span.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::detail {

/// A fragment's colour before it is written, 0..255 a channel.
struct FragmentColour {
  std::uint32_t r, g, b, a;
};

/// Converts RGB565 to 8 bits a channel by repeating the upper bits: 31 and 63 become 255.
constexpr FragmentColour expanded(std::uint16_t pixel) {
  const std::uint32_t r = pixel >> 11, g = (pixel >> 5) & 0x3FU, b = pixel & 0x1FU;
  return {(r << 3) | (r >> 2), (g << 2) | (g >> 4), (b << 3) | (b >> 2), 255};
}

/// Returns the level for a run with these footprints at its ends, in a texture with `smaller_levels`: the logarithm
/// (base 2) of their mean, rounded to nearest.
constexpr std::uint32_t level_of_run(std::uint32_t from, std::uint32_t to, std::uint32_t smaller_levels) {
  const std::uint32_t mean = (from + to) / 2;
  const std::uint32_t times_root_of_two = (mean * 181) >> 15;  // a power of two where the logarithm is halfway between
                                                               // integers
  const auto level = static_cast<std::uint32_t>(31 - std::countl_zero(times_root_of_two | 1));
  return std::min(level, smaller_levels);
}

/// Fetches texels by coordinates in fractions of the texture, 0.32. `palettes`, `levels`: textures may have them.
template <bool palettes, bool levels>
class TextureSampler {
 public:
  using Storage = std::conditional_t<palettes || levels, TexelStorage, Absent>;

  TextureSampler() = default;
  TextureSampler(const TextureView& texture, Storage storage) : storage_(storage), texels_(texture.texels) {
    if constexpr (palettes) {
      if (has_palette(storage.format)) palette_ = texels_, texels_ += std::size_t{1} << index_bits(storage.format);
    }
    if constexpr (levels) first_ = texels_;
    set_size(texture.log2_width, texture.log2_height);
  }

  /// Selects a level that the texture has; 0 is `texture` itself. A coordinate selects the same place in every level.
  void show(const TextureView& texture, std::uint32_t level) requires levels {
    if (level == level_) return;
    level_ = level;
    texels_ = first_;
    std::uint32_t log2_width = texture.log2_width, log2_height = texture.log2_height;
    for (; level != 0; --level) {
      texels_ += level_words(storage_.format, log2_width + log2_height);
      if (log2_width != 0) --log2_width;
      if (log2_height != 0) --log2_height;
    }
    set_size(log2_width, log2_height);
  }

  template <bool alpha>
  FragmentColour nearest(std::uint32_t u, std::uint32_t v, bool has_alpha) const {
    return texel<alpha>(nearest_index(u, v), has_alpha);
  }
  std::uint16_t nearest_word(std::uint32_t u, std::uint32_t v) const { return word(nearest_index(u, v)); }

  /// Returns the mean of the four texels whose centres lie around the point, weighted by distance in 1/256 and rounded
  /// to nearest. Sums are below 2^24 + 2^15.
  template <bool alpha>
  FragmentColour bilinear(std::uint32_t u, std::uint32_t v, bool has_alpha) const {
    const Between x(u, log2_width_), y(v, log2_height_);
    const auto fetch = [&](std::uint32_t column, std::uint32_t row) {
      return texel<alpha>((row << log2_width_) + column, has_alpha);
    };
    const FragmentColour a = fetch(x.first, y.first), b = fetch(x.second, y.first), c = fetch(x.first, y.second),
                         d = fetch(x.second, y.second);
    const auto mean = [&](std::uint32_t FragmentColour::*channel) {
      const std::uint32_t upper = a.*channel * (256 - x.share) + b.*channel * x.share;
      const std::uint32_t lower = c.*channel * (256 - x.share) + d.*channel * x.share;
      return (upper * (256 - y.share) + lower * y.share + 32768) >> 16;
    };
    return {mean(&FragmentColour::r), mean(&FragmentColour::g), mean(&FragmentColour::b), mean(&FragmentColour::a)};
  }

 private:
  void set_size(std::uint32_t log2_width, std::uint32_t log2_height) {
    log2_width_ = log2_width, log2_height_ = log2_height;
    to_column_ = TextureAxis(static_cast<std::uint8_t>(log2_width)).to_index;
    to_row_ = log2_height + log2_width == 0 ? 31 : static_cast<std::int32_t>(32 - log2_height - log2_width);
    row_mask_ = ~((std::uint32_t{1} << log2_width) - 1);
    if constexpr (levels) {
      // In a level that is one texel wide or high, coordinates still range over the whole texture.
      column_mask_ = (std::uint32_t{1} << log2_width) - 1;
      if (log2_height == 0) row_mask_ = 0;
    }
  }

  std::uint32_t nearest_index(std::uint32_t u, std::uint32_t v) const {
    std::uint32_t column = u >> to_column_;
    if constexpr (levels) column &= column_mask_;
    return ((v >> to_row_) & row_mask_) + column;
  }

  std::uint16_t word(std::uint32_t index) const {
    if constexpr (palettes) {
      if (storage_.format == TextureFormat::palette8) {
        return palette_[(texels_[index >> 1] >> (8 * (index & 1))) & 0xFF];
      }
      if (storage_.format == TextureFormat::palette4) {
        return palette_[(texels_[index >> 2] >> (4 * (index & 3))) & 0xF];
      }
    }
    return texels_[index];
  }

  /// Two adjacent texels along an axis that repeats, and the weight of the second one in 1/256.
  struct Between {
    std::uint32_t first = 0, second = 0, share = 0;

    Between(std::uint32_t fraction, std::uint32_t log2_size) {
      if (log2_size == 0) return;
      const std::uint32_t from_centre = fraction - (std::uint32_t{1} << (31 - log2_size));
      first = from_centre >> (32 - log2_size);
      second = (first + 1) & ((std::uint32_t{1} << log2_size) - 1);
      share = (from_centre << log2_size) >> 24;
    }
  };

  template <bool alpha>
  FragmentColour texel(std::uint32_t index, [[maybe_unused]] bool has_alpha) const {
    FragmentColour colour = expanded(word(index));
    if constexpr (alpha) {
      const std::uint32_t texels = std::uint32_t{1} << (log2_width_ + log2_height_);
      if (has_alpha) colour.a = (texels_[texels + (index >> 1)] >> (8 * (index & 1))) & 0xFFU;
    }
    return colour;
  }

  [[no_unique_address]] Storage storage_{};
  const std::uint16_t* texels_ = nullptr;  ///< texels of the level, after the palette
  std::uint32_t log2_width_ = 0, log2_height_ = 0;
  std::int32_t to_column_ = 0, to_row_ = 0;  ///< right shifts; the row remains multiplied by the width
  std::uint32_t row_mask_ = 0;
  [[no_unique_address]] std::conditional_t<palettes, const std::uint16_t*, Absent> palette_{};
  [[no_unique_address]] std::conditional_t<levels, const std::uint16_t*, Absent> first_{};
  [[no_unique_address]] std::conditional_t<levels, std::uint32_t, Absent> level_{}, column_mask_{};
};

}  // namespace zstrip::detail
