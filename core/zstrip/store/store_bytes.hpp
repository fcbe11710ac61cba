// The largest number of bytes that stores and sets of tiles need.
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
/// Returns the bytes before the first record: header, groups and sizes.
constexpr std::uint32_t index_bytes(const TileGrid& grid) {
  return kStoreHeaderBytes + kGroupBytes * groups(grid) + grid.tiles();
}

}  // namespace detail

/// Returns the bytes of a pool that has room for every rectangle of this size, for any cells.
constexpr std::uint32_t store_bytes_worst(std::uint32_t width, std::uint32_t height) {
  return detail::index_bytes({width, height}) + 2 * width * height;
}

/// Returns the words of memory for the dirty tiles of a rectangle: one bit a tile, each row of tiles starts at a word.
constexpr std::uint32_t dirty_tile_words(std::uint32_t width, std::uint32_t height) {
  const TileGrid grid{width, height};
  return (grid.columns() + 31) / 32 * grid.rows();
}

}  // namespace zstrip
