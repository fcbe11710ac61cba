// Encodes and decodes one tile of depth as a record of bytes, without loss. docs/formats.md defines every bit.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip/store/tile.hpp"

namespace zstrip {

/// Writes the shortest record that the encoder finds for these cells and returns its size: 0 if all cells are cleared
/// (0), at most 2 * tile.area().
std::uint32_t encode_depth_tile(const TileView<const std::uint16_t>& tile, std::span<std::byte, kMaxTileRecord> record);

/// Decodes the cells of a record. Returns false if the bytes are not a record of a tile of this size; the tile's cells
/// may then have any value, but no cell outside of it is written. Never reads outside `record`, for any contents.
[[nodiscard]] bool decode_depth_tile(std::span<const std::byte> record, const TileView<std::uint16_t>& tile);

}  // namespace zstrip
