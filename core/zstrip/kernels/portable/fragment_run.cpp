// The stages of kernels/fragment_run.hpp, for every processor.
#include "zstrip/kernels/fragment_run.hpp"

#include <bit>
#include <cstddef>

#include "zstrip/base/bayer.hpp"
#include "zstrip/base/processor.hpp"
#include "zstrip/geometry/light.hpp"
#include "zstrip/kernels/portable/bilinear.hpp"
#include "zstrip/pixels/cell_axis.hpp"
#include "zstrip/pixels/colour.hpp"

namespace zstrip::detail {
namespace {

// Red and blue of a colour share a word: a channel times 0 .. 256 stays within its 16 bits.
constexpr std::uint32_t kRedAndBlue = 0x00FF00FF;
constexpr std::uint32_t kHalves = 0x00800080;  // rounds both to nearest
constexpr std::uint32_t kAlpha = 0xFF000000;

constexpr std::uint32_t red_of(std::uint32_t colour) { return colour >> 16 & 0xFF; }
constexpr std::uint32_t green_of(std::uint32_t colour) { return colour >> 8 & 0xFF; }
constexpr std::uint32_t blue_of(std::uint32_t colour) { return colour & 0xFF; }

// RGB565 as expanded() widens it, two channels at a time.
/// Returns red and blue.
constexpr std::uint32_t red_and_blue(std::uint32_t texel) {
  const std::uint32_t narrow = (texel | texel << 5) & 0x001F001F;
  return (narrow << 3) + (narrow >> 2 & 0x00070007);
}
/// Returns the greens of two texels, the first in the upper half.
constexpr std::uint32_t greens(std::uint32_t first, std::uint32_t second) {
  const std::uint32_t narrow = (first >> 5 & 0x3F) << 16 | (second >> 5 & 0x3F);
  return (narrow << 2) + (narrow >> 4 & 0x00030003);
}
/// Returns all three as a word; alpha is 0.
constexpr std::uint32_t widened(std::uint32_t texel) {
  return red_and_blue(texel) | ((texel >> 5 & 0x3F) * 65 << 4 & 0xFF00);
}

/// The mean of two colours, the first of weight `share` (0 .. 256), rounded to nearest, without alpha. What a
/// difference borrows from another channel, the sum gives back.
struct Mean {
  std::uint32_t red_blue, green;  // 8.8 channels in halves of a word

  constexpr Mean(std::uint32_t colour, std::uint32_t other_red_blue, std::uint32_t other_green, std::uint32_t share)
      : red_blue(((colour & kRedAndBlue) - other_red_blue) * share + (other_red_blue << 8) + kHalves),
        green((green_of(colour) - other_green) * share + (other_green << 8) + 128) {}
  /// Returns the mean with a pixel, weighted by the colour's alpha times `material`.
  static constexpr Mean with_pixel(std::uint32_t colour, std::uint32_t pixel, std::uint32_t material) {
    const std::uint32_t other_green = (pixel >> 5 & 0x3F) << 2 | (pixel >> 9 & 3);
    return {colour, red_and_blue(pixel), other_green, factor((colour >> 24) * material >> 8)};
  }
  constexpr std::uint32_t colour() const { return (red_blue >> 8 & kRedAndBlue) | (green & 0xFF00); }
  constexpr std::uint16_t rgb565() const {
    return static_cast<std::uint16_t>((red_blue >> 27 << 11) | (green >> 10 << 5) | (red_blue >> 11 & 0x1F));
  }
};

/// Two channels of 8 bits in the halves of a word, of a texel and of its right neighbour. A mean stays within a half;
/// a difference may borrow from the other half, and the sum gives it back.
struct Pair {
  std::uint32_t first = 0, step = 0;

  Pair() = default;
  Pair(std::uint32_t left, std::uint32_t right) : first((left << 8) + kHalves), step(right - left) {}
  /// 256 times the means, for a weight of the right one of 0 .. 255; and 1/2, which rounds the mean of two rows.
  std::uint32_t at(std::uint32_t weight) const { return first + step * weight; }
};

/// A channel times light of 8.16, 8.8 with half a unit more.
constexpr std::uint32_t channel_product(std::uint32_t channel, std::uint32_t light) {
  return channel * light_factor(light) + 128;
}
/// The product rounded to nearest.
constexpr std::uint32_t lit(std::uint32_t channel, std::uint32_t light) { return channel_product(channel, light) >> 8; }

/// Byte `index` of a sequence of words whose lower byte is the first.
std::uint32_t byte_at(const std::uint16_t* words, std::uint32_t index) {
  if constexpr (std::endian::native == std::endian::little) {
    return reinterpret_cast<const std::uint8_t*>(words)[index];
  }
  return words[index >> 1] >> 8 * (index & 1) & 0xFF;
}

template <TextureFormat format>
std::uint32_t word_at(const RunTexels& texels, std::uint32_t index) {
  if constexpr (format == TextureFormat::palette8) {
    return texels.palette[byte_at(texels.texels, index)];
  } else if constexpr (format == TextureFormat::palette4) {
    return texels.palette[byte_at(texels.texels, index >> 1) >> 4 * (index & 1) & 0xF];
  } else {
    return texels.texels[index];
  }
}

std::uint32_t alpha_at(const RunTexels& texels, std::uint32_t index) {
  const std::uint16_t* const alphas = texels.texels + (std::size_t{1} << (texels.log2_width + texels.log2_height));
  return byte_at(alphas, index);
}

/// Calls visit(i, index of the nearest texel) for the pixels of a run.
template <class Visit>
[[gnu::always_inline]] inline void for_nearest(const RunTexels& texels, const RunPlace& place, std::int32_t count,
                                               const Visit& visit) {
  // A row stays multiplied by the width. On a side of one texel the mask clears what the shift leaves.
  const std::uint32_t width = texels.log2_width, both = width + texels.log2_height;
  const std::uint32_t to_column = width == 0 ? 31 : 32 - width, column_mask = (1U << width) - 1;
  const std::uint32_t to_row = both == 0 ? 31 : 32 - both, row_mask = ((1U << both) - 1) & ~column_mask;
  std::uint32_t u = place.u, v = place.v;
  for (std::int32_t i = 0; i < count; ++i) {
    visit(i, (v >> to_row & row_mask) + (u >> to_column & column_mask));
    u += place.step_u, v += place.step_v;
  }
}

template <class Visit>
[[gnu::always_inline]] inline void for_format(const RunTexels& texels, const Visit& visit) {
  switch (texels.format) {
    case TextureFormat::palette8: return visit.template operator()<TextureFormat::palette8>();
    case TextureFormat::palette4: return visit.template operator()<TextureFormat::palette4>();
    default: return visit.template operator()<TextureFormat::rgb565>();
  }
}

/// Sets colours to set(word) of the nearest texels. The format is decided once; for size, at each texel.
template <bool palettes, class Set>
[[gnu::always_inline]] inline void fetch(const RunTexels& texels, const RunPlace& place, std::uint32_t* colours,
                                         std::int32_t count, const Set& set) {
  const auto all = [&](const auto& word) {
    for_nearest(texels, place, count, [&](std::int32_t i, std::uint32_t index) { colours[i] = set(word(index)); });
  };
  if constexpr (!palettes) {
    all([&](std::uint32_t index) { return word_at<TextureFormat::rgb565>(texels, index); });
  } else if constexpr (kForSize) {
    all([&](std::uint32_t index) {
      std::uint32_t word = 0;
      for_format(texels, [&]<TextureFormat format>() { word = word_at<format>(texels, index); });
      return word;
    });
  } else {
    for_format(texels, [&]<TextureFormat format>() {
      all([&](std::uint32_t index) { return word_at<format>(texels, index); });
    });
  }
}

}  // namespace

template <bool palettes>
void fetch_words(const RunTexels& texels, const RunPlace& place, std::uint32_t* colours, std::int32_t count) {
  fetch<palettes>(texels, place, colours, count, [](std::uint32_t word) { return word; });
}
template void fetch_words<false>(const RunTexels&, const RunPlace&, std::uint32_t*, std::int32_t);
template void fetch_words<true>(const RunTexels&, const RunPlace&, std::uint32_t*, std::int32_t);

template <bool palettes>
void fetch_nearest(const RunTexels& texels, const RunPlace& place, std::uint32_t* colours, std::int32_t count) {
  if constexpr (kForSize) {
    fetch_words<palettes>(texels, place, colours, count);
    for (std::int32_t i = 0; i < count; ++i) colours[i] = kAlpha | widened(colours[i]);
  } else {
    fetch<palettes>(texels, place, colours, count, [](std::uint32_t word) { return kAlpha | widened(word); });
  }
}
template void fetch_nearest<false>(const RunTexels&, const RunPlace&, std::uint32_t*, std::int32_t);
template void fetch_nearest<true>(const RunTexels&, const RunPlace&, std::uint32_t*, std::int32_t);

template <bool palettes, bool alpha>
void fetch_bilinear_portable(const RunTexels& texels, const RunPlace& place, std::uint32_t* colours,
                             std::int32_t count) {
  const std::uint32_t width = texels.log2_width, height = texels.log2_height;
  const CellAxis across(place.u, place.step_u, width), along(place.v, place.step_v, height);
  // Neighbouring pixels often lie between the same four texels, whose pairs are kept. Green is a pair of the two rows.
  Pair upper, lower, both_greens, alphas;
  std::uint32_t* const end = colours + count;
  for (std::uint32_t* colour = colours; colour != end;) {
    const auto i = static_cast<std::int32_t>(colour - colours);
    const std::uint32_t u = across.at(i), v = along.at(i);
    std::uint32_t x = across.in_cell(u), y = along.in_cell(v);
    const std::uint32_t column = across.texel(u), row = along.texel(v) << width;
    const std::uint32_t next_column = (column + 1) & ((1U << width) - 1);
    const std::uint32_t next_row = (row + (1U << width)) & ((1U << (width + height)) - 1);
    const std::uint32_t indices[4] = {row + column, row + next_column, next_row + column, next_row + next_column};
    std::uint32_t a = 0, b = 0, c = 0, d = 0;
    const auto read = [&]<TextureFormat format>() {
      a = word_at<format>(texels, indices[0]), b = word_at<format>(texels, indices[1]);
      c = word_at<format>(texels, indices[2]), d = word_at<format>(texels, indices[3]);
    };
    if constexpr (palettes) {
      for_format(texels, read);
    } else {
      read.template operator()<TextureFormat::rgb565>();
    }
    upper = Pair(red_and_blue(a), red_and_blue(b));
    lower = Pair(red_and_blue(c), red_and_blue(d));
    both_greens = Pair(greens(a, c), greens(b, d));
    if constexpr (alpha) {
      alphas = Pair(alpha_at(texels, indices[0]) << 16 | alpha_at(texels, indices[2]),
                    alpha_at(texels, indices[1]) << 16 | alpha_at(texels, indices[3]));
    }
    do {
      const std::uint32_t right = CellAxis::weight(x), down = CellAxis::weight(y), up = 256 - down;
      x += across.step_in_cell, y += along.step_in_cell;
      const auto between = [up, down](std::uint32_t above, std::uint32_t below) {  // 16 bits each; the mean is in the
        return above * up + below * down;                                          // upper 8 of 24 bits
      };
      const std::uint32_t above = upper.at(right), below = lower.at(right), green = both_greens.at(right);
      std::uint32_t mixed = (between(above >> 16, below >> 16) & 0xFF0000) |
                            (between(green >> 16, green & 0xFFFF) >> 8 & 0xFF00) |
                            between(above & 0xFFFF, below & 0xFFFF) >> 16;
      if constexpr (alpha) {
        const std::uint32_t both = alphas.at(right);
        mixed |= between(both >> 16, both & 0xFFFF) >> 16 << 24;
      } else {
        mixed |= kAlpha;
      }
      *colour++ = mixed;
    } while (colour != end && ((x | y) & CellAxis::kOutside) == 0);
  }
}
template void fetch_bilinear_portable<false, false>(const RunTexels&, const RunPlace&, std::uint32_t*, std::int32_t);
template void fetch_bilinear_portable<false, true>(const RunTexels&, const RunPlace&, std::uint32_t*, std::int32_t);
template void fetch_bilinear_portable<true, false>(const RunTexels&, const RunPlace&, std::uint32_t*, std::int32_t);
template void fetch_bilinear_portable<true, true>(const RunTexels&, const RunPlace&, std::uint32_t*, std::int32_t);

void fetch_alpha(const RunTexels& texels, const RunPlace& place, std::uint32_t* colours, std::int32_t count) {
  for_nearest(texels, place, count, [&](std::int32_t i, std::uint32_t index) {
    colours[i] = (colours[i] & ~kAlpha) | alpha_at(texels, index) << 24;
  });
}

void set_to_light(const RunLight& light, std::uint32_t* colours, std::int32_t count) {
  std::uint32_t r = light.r, g = light.g, b = light.b;
  for (std::int32_t i = 0; i < count; ++i) {
    colours[i] = kAlpha | (r & 0xFF0000) | (g >> 16) << 8 | b >> 16;
    r += light.step_r, g += light.step_g, b += light.step_b;
  }
}

void multiply_by_light(const RunLight& light, std::uint32_t* colours, std::int32_t count) {
  std::uint32_t r = light.r, g = light.g, b = light.b;
  for (std::int32_t i = 0; i < count; ++i) {
    const std::uint32_t colour = colours[i];
    colours[i] =
        (colour & kAlpha) | lit(red_of(colour), r) << 16 | lit(green_of(colour), g) << 8 | lit(blue_of(colour), b);
    r += light.step_r, g += light.step_g, b += light.step_b;
  }
}

void multiply_by_colours(const std::uint32_t* factors, std::uint32_t* colours, std::int32_t count) {
  for (std::int32_t i = 0; i < count; ++i) {
    const std::uint32_t colour = colours[i], by = factors[i];
    colours[i] = (colour & kAlpha) | lit(red_of(colour), red_of(by) << 16) << 16 |
                 lit(green_of(colour), green_of(by) << 16) << 8 | lit(blue_of(colour), blue_of(by) << 16);
  }
}

void write_lit(const RunLight& light, const std::uint32_t* colours, std::uint16_t* pixels, std::int32_t count) {
  if constexpr (kForSize) {  // two calls instead of a stage of its own
    RunColours lit;
    for (std::int32_t i = 0; i < count; ++i) lit[i] = colours[i];
    multiply_by_light(light, lit, count);
    return write_packed(lit, pixels, count);
  }
  std::uint32_t r = light.r, g = light.g, b = light.b;
  for (std::int32_t i = 0; i < count; ++i) {
    const std::uint32_t colour = colours[i];
    const std::uint32_t red = channel_product(red_of(colour), r), green = channel_product(green_of(colour), g),
                        blue = channel_product(blue_of(colour), b);
    pixels[i] = static_cast<std::uint16_t>((red >> 11 << 11) | (green >> 10 << 5) | blue >> 11);
    r += light.step_r, g += light.step_g, b += light.step_b;
  }
}

void write_lit_words(const RunLight& light, const std::uint32_t* words, std::uint16_t* pixels, std::int32_t count) {
  std::uint32_t r = light.r, g = light.g, b = light.b;
  for (std::int32_t i = 0; i < count; ++i) {
    pixels[i] = modulated(static_cast<std::uint16_t>(words[i]), r, g, b);
    r += light.step_r, g += light.step_g, b += light.step_b;
  }
}

void multiply_alpha(std::uint32_t material, std::uint32_t* colours, std::int32_t count) {
  for (std::int32_t i = 0; i < count; ++i) {
    colours[i] = (colours[i] & ~kAlpha) | (((colours[i] >> 24) * material) >> 8) << 24;
  }
}

void mix_fog(const Colour& fog, std::int32_t visible, std::int32_t step, std::uint32_t* colours, std::int32_t count) {
  const std::uint32_t red_blue = std::uint32_t{fog.r} << 16 | fog.b;
  for (std::int32_t i = 0; i < count; ++i) {
    const std::uint32_t colour = colours[i];
    const Mean mean(colour, red_blue, fog.g, static_cast<std::uint32_t>(visible) >> 16);
    colours[i] = (colour & kAlpha) | mean.colour();
    visible += step;
  }
}

void mix_behind(const std::uint16_t* behind, std::uint32_t material, std::uint32_t* colours, std::int32_t count) {
  for (std::int32_t i = 0; i < count; ++i) {
    const std::uint32_t colour = colours[i];
    colours[i] = (colour & kAlpha) | Mean::with_pixel(colour, behind[i], material).colour();
  }
}

void write_mixed(const std::uint16_t* behind, std::uint32_t material, const std::uint32_t* colours,
                 std::uint16_t* pixels, std::int32_t count) {
  for (std::int32_t i = 0; i < count; ++i) {
    pixels[i] = Mean::with_pixel(colours[i], behind[i], material).rgb565();
  }
}

void write_fogged_light(const RunLight& light, const Colour& fog, std::int32_t visible, std::int32_t step,
                        std::uint16_t* pixels, std::int32_t count) {
  // Green is stepped as its difference to the fog; red and blue share a word, as in Mean.
  const std::uint32_t fog_red_blue = std::uint32_t{fog.r} << 16 | fog.b;
  const std::uint32_t red_blue_end = (fog_red_blue << 8) + kHalves, green_end = (std::uint32_t{fog.g} << 8) + 128;
  std::uint32_t r = light.r, g = light.g - (std::uint32_t{fog.g} << 16), b = light.b;
  for (std::int32_t i = 0; i < count; ++i) {
    const std::uint32_t share = static_cast<std::uint32_t>(visible) >> 16;
    const std::uint32_t red_blue = (((r & 0xFF0000) | b >> 16) - fog_red_blue) * share + red_blue_end;
    const std::uint32_t green = static_cast<std::uint32_t>(static_cast<std::int32_t>(g) >> 16) * share + green_end;
    pixels[i] = static_cast<std::uint16_t>((red_blue >> 27 << 11) | (green >> 10 << 5) | (red_blue >> 11 & 0x1F));
    r += light.step_r, g += light.step_g, b += light.step_b, visible += step;
  }
}

void write_packed(const std::uint32_t* colours, std::uint16_t* pixels, std::int32_t count) {
  for (std::int32_t i = 0; i < count; ++i) {
    const std::uint32_t c = colours[i];
    pixels[i] = static_cast<std::uint16_t>((c >> 8 & 0xF800) | (c >> 5 & 0x07E0) | (c >> 3 & 0x001F));
  }
}

void write_dithered(const std::uint8_t (&thresholds)[8], std::uint32_t column, const std::uint32_t* colours,
                    std::uint16_t* pixels, std::int32_t count) {
  for (std::int32_t i = 0; i < count; ++i, ++column) {
    const std::uint32_t c = colours[i];
    pixels[i] = dithered_rgb565(red_of(c), green_of(c), blue_of(c), thresholds[column & 7]);
  }
}

}  // namespace zstrip::detail
