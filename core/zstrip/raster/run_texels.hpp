// The texels that a run of fragments reads: those of one level of a texture.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "zstrip/kernels/fragment_run.hpp"
#include "zstrip/pixels/target.hpp"
#include "zstrip/raster/fragment_settings.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::detail {

/// Returns the texture's own texels, level 0.
inline RunTexels texels_of(const TextureView& texture, TextureFormat format) {
  RunTexels texels{texture.texels, texture.texels, texture.log2_width, texture.log2_height, format};
  if (has_palette(format)) texels.texels += std::size_t{1} << index_bits(format);
  return texels;
}

/// Returns a level that the texture has. A coordinate selects the same place in every level.
inline RunTexels level_of(RunTexels texels, std::uint32_t level) {
  for (; level != 0; --level) {
    texels.texels += level_words(texels.format, texels.log2_width + texels.log2_height);
    if (texels.log2_width != 0) --texels.log2_width;
    if (texels.log2_height != 0) --texels.log2_height;
  }
  return texels;
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

}  // namespace zstrip::detail
