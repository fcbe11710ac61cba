// Computes the smaller levels of a texture: means of its texels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "zstrip/scene.hpp"

namespace zstrip::sim {

/// Returns the number of levels below the first, down to one texel.
std::uint8_t most_smaller_levels(const Texture& texture);

/// Returns the words of `texture` with so many smaller levels; existing smaller levels are ignored. A texel is the mean
/// of the texels of the first level that it represents, rounded to nearest. Channels are averaged without gamma, as
/// light and filters use them, and weighted by alpha if there is one; alpha is the mean of their alphas. With a
/// palette, a texel is the entry that is nearest to the mean. The same texels give the same words on every machine.
std::vector<std::uint16_t> with_smaller_levels(const Texture& texture, std::uint8_t levels);

/// Returns only the first level, with the same words.
Texture without_smaller_levels(const Texture& texture);

/// Returns the number of texels of each level, including the first.
std::vector<std::size_t> level_sizes(const Texture& texture);

}  // namespace zstrip::sim
