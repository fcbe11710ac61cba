// Where the record of each tile lies in a pool: sizes of all tiles and a position for each group of them. Every number
// that is read from the pool is checked before it is used.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip/store/store_bytes.hpp"

namespace zstrip::detail {

/// Records lie in the order of their tiles. Between two of them is one gap, which holds all free bytes: those before it
/// stand at the front of the pool, those after it at the end.
struct Gap {
  std::uint32_t tile = 0;            ///< the first one after the gap
  std::uint32_t begin = 0, end = 0;  ///< bytes from the start of the pool
  constexpr std::uint32_t size() const { return end - begin; }
};

/// Positions are bytes from the start of the pool.
class TileIndex {
 public:
  TileIndex() = default;
  /// Of a pool that is only read. At least index_bytes(grid) bytes, less than 2^31.
  TileIndex(std::span<const std::byte> pool, const TileGrid& grid, const Gap& gap)
      : pool_(pool), grid_(grid), gap_(gap) {}
  /// Writes the index of `grid` with all tiles empty.
  TileIndex(std::span<std::byte> pool, const TileGrid& grid, std::uint8_t kind);

  const TileGrid& grid() const { return grid_; }
  const Gap& gap() const { return gap_; }
  std::span<const std::byte> pool() const { return pool_; }

  /// Where tile 0..tiles() - 1 begins, if the pool is not damaged; else any number, also beyond the pool.
  std::uint32_t position(std::uint32_t tile) const;
  /// Where the next tile begins, if this one begins at `position`.
  std::uint32_t next(std::uint32_t tile, std::uint32_t position) const {
    return tile + 1 == gap_.tile ? gap_.end : position + size(tile);
  }
  std::uint8_t size(std::uint32_t tile) const { return std::to_integer<std::uint8_t>(pool_[sizes_at() + tile]); }
  /// The tile's record at its position; false if it does not lie in the pool.
  bool record(std::uint32_t tile, std::uint32_t position, std::span<const std::byte>& bytes) const;

  /// Only for pools that may be written. Puts `record` in the place of the tile's old one; the caller has checked that
  /// the gap and the old record together have room for it. False if the pool is damaged: then no record was lost.
  bool replace(std::uint32_t tile, std::span<const std::byte> record);
  /// Moves the gap before a tile, or behind the last one. False if the pool is damaged: then nothing was moved.
  bool move_gap(std::uint32_t tile);

 private:
  std::uint32_t sizes_at() const { return kStoreHeaderBytes + kGroupBytes * groups(grid_); }
  std::uint32_t pool_size() const { return static_cast<std::uint32_t>(pool_.size()); }
  /// Where a group's first tile begins. Groups before the gap count from the first record, those after it backwards
  /// from the end of the pool: so a new size changes none of them.
  std::uint32_t group(std::uint32_t index, std::uint32_t gap_tile) const;
  void set_group(std::uint32_t index, std::uint32_t position);

  std::span<const std::byte> pool_;
  std::byte* bytes_ = nullptr;  ///< of the pool, if it may be written
  TileGrid grid_;
  Gap gap_;
};

}  // namespace zstrip::detail
