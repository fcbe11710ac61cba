// Converts RGB565 texels to indices of a palette: lossless if there are few enough colours, else by median cut.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "zstrip/scene.hpp"

namespace zstrip::sim {

/// The errors of texels' channels, red, green, blue, in 1/255 of their range.
struct TexelErrors {
  std::array<int, 3> largest{};
  std::array<double, 3> mean{};
};

struct IndexedTexels {
  std::vector<std::uint16_t> words;  ///< for Texture::texels: the palette, then the indices
  TexelErrors errors;
};

/// `format`: palette8 or palette4. Lossless if there are at most as many colours as entries. With more colours, the box
/// around them is halved across its longest side until there are enough boxes; the mean of each box is an entry, and a
/// texel gets the nearest entry (P. Heckbert, "Color image quantization for frame buffer display", SIGGRAPH 1982). The
/// same texels give the same words on every machine. `levels`: the number of texels of each level, one level after the
/// other; the indices of each level begin at a new word.
IndexedTexels index_texels(std::span<const std::uint16_t> texels, TextureFormat format,
                           std::span<const std::size_t> levels);
/// Converts one level.
IndexedTexels index_texels(std::span<const std::uint16_t> texels, TextureFormat format);

/// Returns the index of the entry (of 1..256 entries) that is nearest to the colour, the first of several.
std::uint8_t nearest_entry(std::span<const std::uint16_t> palette, std::uint16_t colour);

/// Appends values of 4 or 8 bits, as many in a word as fit, the first in the lowest bits.
void append_packed(std::span<const std::uint8_t> values, std::uint32_t bits, std::vector<std::uint16_t>& words);

}  // namespace zstrip::sim
