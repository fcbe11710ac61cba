// Tiles of a stored rectangle: 8 x 8 cells of 16 bits. Tiles at the right and lower border may be smaller.
#pragma once

#include <algorithm>
#include <cstdint>

namespace zstrip {

inline constexpr std::uint32_t kTileSide = 8;
inline constexpr std::uint32_t kTileCells = kTileSide * kTileSide;
/// Bytes. No record of a tile is longer: 16 bits a cell.
inline constexpr std::uint32_t kMaxTileRecord = 2 * kTileCells;

/// The cells of one tile in the caller's memory: 1..8 columns and rows, `stride` cells from row to row.
template <typename Cell>
struct TileView {
  Cell* cells;
  std::uint32_t stride;
  std::uint32_t width, height;

  constexpr Cell* row(std::uint32_t y) const { return cells + y * stride; }
  constexpr std::uint32_t area() const { return width * height; }
};

/// The division of a rectangle of 1..4096 x 1..4096 cells into tiles, numbered row by row.
struct TileGrid {
  std::uint32_t width = 0, height = 0;  ///< cells; 0, 0: no tiles

  constexpr std::uint32_t columns() const { return (width + kTileSide - 1) / kTileSide; }
  constexpr std::uint32_t rows() const { return (height + kTileSide - 1) / kTileSide; }
  constexpr std::uint32_t tiles() const { return columns() * rows(); }
  constexpr std::uint32_t tile_width(std::uint32_t tx) const { return std::min(width - tx * kTileSide, kTileSide); }
  constexpr std::uint32_t tile_height(std::uint32_t ty) const { return std::min(height - ty * kTileSide, kTileSide); }
  constexpr bool has(std::uint32_t tx, std::uint32_t ty) const { return tx < columns() && ty < rows(); }
  friend constexpr bool operator==(const TileGrid&, const TileGrid&) = default;
};

}  // namespace zstrip
