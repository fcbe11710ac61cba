// One tile of depth as a record of bytes, without loss. docs/formats.md gives every bit of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip/store/tile.hpp"

namespace zstrip {

/// Writes the shortest record that is known for these cells and returns its size: 0 if all of them are cleared (0), at
/// most 2 * tile.area().
std::uint32_t encode_depth_tile(const TileView<const std::uint16_t>& tile, std::span<std::byte, kMaxTileRecord> record);

/// The cells of a record. False if these bytes are no record of a tile of this size; cells of the tile may then hold
/// anything, and none outside it is touched. Never reads outside `record`, whatever it holds.
[[nodiscard]] bool decode_depth_tile(std::span<const std::byte> record, const TileView<std::uint16_t>& tile);

}  // namespace zstrip
