// Encodes and decodes one tile of RGB565 as a record of bytes, without loss. docs/formats.md defines every bit.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip/store/tile.hpp"

namespace zstrip {

/// Writes the shortest record that the encoder finds for these pixels and returns its size, 2..2 * tile.area().
std::uint32_t encode_colour_tile(const TileView<const std::uint16_t>& tile,
                                 std::span<std::byte, kMaxTileRecord> record);

/// Decodes the pixels of a record. An empty record is a tile that was never written: all pixels are 0. Returns false if
/// the bytes are not a record of a tile of this size; the tile's pixels may then have any value, but no pixel outside
/// of it is written. Never reads outside `record`, for any contents.
[[nodiscard]] bool decode_colour_tile(std::span<const std::byte> record, const TileView<std::uint16_t>& tile);

}  // namespace zstrip
