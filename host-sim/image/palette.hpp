// Texels of RGB565 as indices of a palette: without loss where there are few enough colours, else by median cut.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "zstrip/scene/scene.hpp"

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
/// The same texels give the same words everywhere.
IndexedTexels index_texels(std::span<const std::uint16_t> texels, TextureFormat format);

}  // namespace zstrip::sim
