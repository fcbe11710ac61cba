// A rectangle of 16-bit cells, compressed without loss tile by tile in memory that the caller lends.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip/status.hpp"
#include "zstrip/store/tile_index.hpp"
#include "zstrip/view.hpp"

namespace zstrip {

/// Rows top .. top + rows of a store's rectangle in the caller's memory: all columns, `stride` cells from row to row.
template <typename Cell>
struct RowsView {
  Cell* cells;
  std::uint32_t stride;
  std::uint32_t top, rows;
};

namespace detail {

/// The kind of data in a store. The functions are those of depth_tile.hpp and colour_tile.hpp.
struct TileCodec {
  std::uint8_t kind;  ///< stored in the header of a pool
  Purpose purpose;
  std::uint32_t (*encode)(const TileView<const std::uint16_t>&, std::span<std::byte, kMaxTileRecord>);
  bool (*decode)(std::span<const std::byte>, const TileView<std::uint16_t>&);
};

/// The reading part of all stores. Reads nothing outside the pool, for any contents.
class TileReader {
 public:
  const TileGrid& grid() const { return index_.grid(); }

  /// Decodes a tile into grid().tile_width(tx) x grid().tile_height(ty) cells. Error::store_range if there is no such
  /// tile; Error::store_damaged if its bytes are not a record: its cells may then have any value.
  Status read_tile(std::uint32_t tx, std::uint32_t ty, std::uint16_t* cells, std::uint32_t stride) const;
  /// Decodes whole rows; fastest if they are whole tiles. Stops at the first damaged tile.
  Status read_rows(const RowsView<std::uint16_t>& rows) const;
  /// Checks that each tile's record lies at its position in the index, does not overlap another, and can be decoded.
  Status validate() const;

 protected:
  explicit constexpr TileReader(const TileCodec& held) : codec_(&held) {}
  /// Checks the header, and that the index lies in the blob. The blob must stay alive.
  Status open(std::span<const std::byte> blob);

  Status check_rows(std::uint32_t top, std::uint32_t rows) const;
  Status decode(std::uint32_t tile, std::uint32_t position, const TileView<std::uint16_t>& cells) const;

  const TileCodec* codec_;
  TileIndex index_;
};

/// The writing part of all stores. The pool must stay alive, and must not be changed from outside.
class TileStore : public TileReader {
 public:
  /// Makes an empty rectangle of width x height cleared cells (1..4096 each). Error::view_size; Error::store_full if
  /// `pool` has no room for the index (`needed`). The former contents of the pool do not matter.
  Status reset(std::span<std::byte> pool, std::uint32_t width, std::uint32_t height);

  /// Encodes a tile of grid().tile_width(tx) x grid().tile_height(ty) cells, and replaces its old record. Tiles may be
  /// written in any order, and repeatedly; the order of rows is the fastest. Error::store_range; Error::store_full if
  /// there is no room for the record (`needed`, `available` in bytes of the whole pool): then no tile has changed.
  Status write_tile(std::uint32_t tx, std::uint32_t ty, const std::uint16_t* cells, std::uint32_t stride);
  /// Encodes whole rows. Tiles that are larger than these rows keep their other rows. Fastest if the rows are whole
  /// tiles. Stops at the first tile without room: the tiles before it are written, this tile and the tiles after it are
  /// not.
  Status write_rows(const RowsView<const std::uint16_t>& rows);

  /// Returns the bytes of the pool that are in use; the rest is free, in one piece.
  std::uint32_t bytes_used() const;
  /// Returns the store as a blob for a reader: the front of the pool, valid until the next write. Empty before a reset
  /// and if the pool is damaged.
  std::span<const std::byte> blob();

 protected:
  explicit constexpr TileStore(const TileCodec& held) : TileReader(held) {}

 private:
  Status write(std::uint32_t tile, const TileView<const std::uint16_t>& cells);
};

}  // namespace detail
}  // namespace zstrip
