// One tile of RGB565 as a record of bytes, without loss. docs/formats.md gives every bit of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip/store/tile.hpp"

namespace zstrip {

/// Writes the shortest record that is known for these pixels and returns its size, 2..2 * tile.area().
std::uint32_t encode_colour_tile(const TileView<const std::uint16_t>& tile,
                                 std::span<std::byte, kMaxTileRecord> record);

/// The pixels of a record; all 0 if it is empty, as a tile is that was never written. False if these bytes are no
/// record of a tile of this size; pixels of the tile may then hold anything, and none outside it is touched. Never
/// reads outside `record`, whatever it holds.
[[nodiscard]] bool decode_colour_tile(std::span<const std::byte> record, const TileView<std::uint16_t>& tile);

}  // namespace zstrip
