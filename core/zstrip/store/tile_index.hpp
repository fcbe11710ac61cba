// The position of each tile's record in a pool: sizes of all tiles, and a position for each group of tiles. Every
// number that is read from the pool is checked before it is used.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip/store/store_bytes.hpp"

namespace zstrip::detail {

/// Records lie in the order of their tiles. One gap between two of them holds all free bytes: records before the gap
/// lie at the front of the pool, records after it at the end.
struct Gap {
  std::uint32_t tile = 0;            ///< the first tile after the gap
  std::uint32_t begin = 0, end = 0;  ///< bytes from the start of the pool
  constexpr std::uint32_t size() const { return end - begin; }
};

/// Positions are bytes from the start of the pool.
class TileIndex {
 public:
  TileIndex() = default;
  /// Opens a pool that is only read. It has at least index_bytes(grid) bytes, less than 2^31.
  TileIndex(std::span<const std::byte> pool, const TileGrid& grid, const Gap& gap)
      : pool_(pool), grid_(grid), gap_(gap) {}
  /// Writes the index of `grid` with all tiles empty.
  TileIndex(std::span<std::byte> pool, const TileGrid& grid, std::uint8_t kind);

  const TileGrid& grid() const { return grid_; }
  const Gap& gap() const { return gap_; }
  std::span<const std::byte> pool() const { return pool_; }

  /// Returns the position of tile 0..tiles() - 1. If the pool is damaged, it may be any number, also outside of the
  /// pool.
  std::uint32_t position(std::uint32_t tile) const;
  /// Returns the position of the next tile, if this tile begins at `position`.
  std::uint32_t next(std::uint32_t tile, std::uint32_t position) const {
    return tile + 1 == gap_.tile ? gap_.end : position + size(tile);
  }
  std::uint8_t size(std::uint32_t tile) const { return std::to_integer<std::uint8_t>(pool_[sizes_at() + tile]); }
  /// Sets `bytes` to the tile's record at its position; returns false if it does not lie in the pool.
  bool record(std::uint32_t tile, std::uint32_t position, std::span<const std::byte>& bytes) const;

  /// Only for pools that may be written. Replaces the tile's record by `record`; the caller has checked that the gap
  /// and the old record together have room for it. Returns false if the pool is damaged: then no record was lost.
  bool replace(std::uint32_t tile, std::span<const std::byte> record);
  /// Moves the gap before a tile, or after the last one. Returns false if the pool is damaged: then nothing was moved.
  bool move_gap(std::uint32_t tile);

 private:
  std::uint32_t sizes_at() const { return kStoreHeaderBytes + kGroupBytes * groups(grid_); }
  std::uint32_t pool_size() const { return static_cast<std::uint32_t>(pool_.size()); }
  /// Returns the position of a group's first tile. Groups before the gap count from the first record, groups after it
  /// backwards from the end of the pool, so that a new size does not change them.
  std::uint32_t group(std::uint32_t index, std::uint32_t gap_tile) const;
  void set_group(std::uint32_t index, std::uint32_t position);

  std::span<const std::byte> pool_;
  std::byte* bytes_ = nullptr;  ///< the bytes of the pool if it may be written; else null
  TileGrid grid_;
  Gap gap_;
};

}  // namespace zstrip::detail
