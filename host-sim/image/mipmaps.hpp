// The smaller levels of a texture: means of its texels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "zstrip/scene.hpp"

namespace zstrip::sim {

/// Levels below the first, down to one texel.
std::uint8_t most_smaller_levels(const Texture& texture);

/// Words of `texture` with so many smaller levels; those that it has already are not looked at. A texel is the mean of
/// all texels of the first level that it stands for, of the channels as they are (without gamma, as light and filters
/// take them), rounded to nearest; with alpha weighted by it, and its alpha the mean of theirs; with a palette the
/// entry that is nearest to the mean. The same texels give the same words everywhere.
std::vector<std::uint16_t> with_smaller_levels(const Texture& texture, std::uint8_t levels);

/// The first level alone, of the same words.
Texture without_smaller_levels(const Texture& texture);

/// Texels of each level, the first included.
std::vector<std::size_t> level_sizes(const Texture& texture);

}  // namespace zstrip::sim
