// Texels of RGB565 as indices of a palette: without loss where there are few enough colours, else by median cut.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "zstrip/scene.hpp"

namespace zstrip::sim {

/// How far the channels of texels are off, red, green, blue, in 1/255 of their range.
struct TexelErrors {
  std::array<int, 3> largest{};
  std::array<double, 3> mean{};
};

struct IndexedTexels {
  std::vector<std::uint16_t> words;  ///< of Texture::texels: the palette, then the indices
  TexelErrors errors;
};

/// `format`: palette8 or palette4. As many colours as it has entries lose nothing; of more, the box around them is
/// halved across its longest side until there are enough boxes, each of which gives the mean of its texels, and a texel
/// gets the nearest of these (P. Heckbert, "Color image quantization for frame buffer display", SIGGRAPH 1982).
/// The same texels give the same words everywhere. `levels`: so many texels each, all of them in a row; the indices of
/// each begin in a word of their own.
IndexedTexels index_texels(std::span<const std::uint16_t> texels, TextureFormat format,
                           std::span<const std::size_t> levels);
/// Of one level.
IndexedTexels index_texels(std::span<const std::uint16_t> texels, TextureFormat format);

/// The index of the entry (one of 256 at most, at least one) that is nearest to the colour, the first of several.
std::uint8_t nearest_entry(std::span<const std::uint16_t> palette, std::uint16_t colour);

/// Appends values of 4 or 8 bits, as many in a word as it holds, the first in the lowest bits.
void append_packed(std::span<const std::uint8_t> values, std::uint32_t bits, std::vector<std::uint16_t>& words);

}  // namespace zstrip::sim
