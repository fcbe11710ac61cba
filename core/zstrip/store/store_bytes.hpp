// How many bytes stores and sets of tiles take at most.
#pragma once

#include <cstdint>

#include "zstrip/store/tile.hpp"

namespace zstrip {
namespace detail {

inline constexpr std::uint32_t kStoreHeaderBytes = 8;
inline constexpr std::uint32_t kTilesPerGroup = 32;
inline constexpr std::uint32_t kGroupBytes = 4;
inline constexpr std::uint8_t kStoreVersion = 1;

constexpr std::uint32_t groups(const TileGrid& grid) { return (grid.tiles() + kTilesPerGroup - 1) / kTilesPerGroup; }
/// Header, groups, sizes: what lies before the first record.
constexpr std::uint32_t index_bytes(const TileGrid& grid) {
  return kStoreHeaderBytes + kGroupBytes * groups(grid) + grid.tiles();
}

}  // namespace detail

/// Bytes of a pool in which every rectangle of this size has room, whatever its cells hold.
constexpr std::uint32_t store_bytes_worst(std::uint32_t width, std::uint32_t height) {
  return detail::index_bytes({width, height}) + 2 * width * height;
}

/// Words of memory for the dirty tiles of a rectangle: a bit a tile, each row of tiles from a word on.
constexpr std::uint32_t dirty_tile_words(std::uint32_t width, std::uint32_t height) {
  const TileGrid grid{width, height};
  return (grid.columns() + 31) / 32 * grid.rows();
}

}  // namespace zstrip
