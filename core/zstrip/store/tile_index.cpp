// Positions of records, and the gap, which moves to the record that is replaced. Writing records one after the other
// moves no bytes, and the free bytes are always in one piece.
#include "zstrip/store/tile_index.hpp"

#include <cstring>

namespace zstrip::detail {
namespace {

std::uint32_t load32(const std::byte* bytes) {
  std::uint32_t value = 0;
  for (int i = 3; i >= 0; --i) value = value << 8 | std::to_integer<std::uint32_t>(bytes[i]);
  return value;
}

void store32(std::byte* bytes, std::uint32_t value) {
  for (int i = 0; i < 4; ++i) bytes[i] = static_cast<std::byte>(value >> (8 * i));
}

}  // namespace

std::uint32_t TileIndex::group(std::uint32_t index, std::uint32_t gap_tile) const {
  const std::uint32_t distance = load32(pool_.data() + kStoreHeaderBytes + kGroupBytes * index);
  return index * kTilesPerGroup < gap_tile ? index_bytes(grid_) + distance : pool_size() - distance;
}

void TileIndex::set_group(std::uint32_t index, std::uint32_t position) {
  const bool before_gap = index * kTilesPerGroup < gap_.tile;
  store32(bytes_ + kStoreHeaderBytes + kGroupBytes * index,
          before_gap ? position - index_bytes(grid_) : pool_size() - position);
}

std::uint32_t TileIndex::position(std::uint32_t tile) const {
  std::uint32_t position = group(tile / kTilesPerGroup, gap_.tile);
  for (std::uint32_t at = tile - tile % kTilesPerGroup; at < tile; ++at) position = next(at, position);
  return position;
}

bool TileIndex::record(std::uint32_t tile, std::uint32_t position, std::span<const std::byte>& bytes) const {
  const std::uint32_t length = size(tile);
  if (position > pool_.size() || length > pool_.size() - position) return false;
  bytes = pool_.subspan(position, length);
  return true;
}

TileIndex::TileIndex(std::span<std::byte> pool, const TileGrid& grid, std::uint8_t kind)
    : pool_(pool),
      bytes_(pool.data()),
      grid_(grid),
      gap_{0, index_bytes(grid), static_cast<std::uint32_t>(pool.size())} {
  const std::uint32_t header[kStoreHeaderBytes] = {
      'z', 's', kStoreVersion, kind, grid.width, grid.width >> 8, grid.height, grid.height >> 8};
  for (std::uint32_t i = 0; i < kStoreHeaderBytes; ++i) bytes_[i] = static_cast<std::byte>(header[i]);
  // All tiles are empty and lie after the gap, at the end of the pool.
  std::memset(bytes_ + kStoreHeaderBytes, 0, index_bytes(grid) - kStoreHeaderBytes);
}

bool TileIndex::move_gap(std::uint32_t tile) {
  if (tile == gap_.tile) return true;
  const Gap old = gap_;
  const std::uint32_t position = tile < grid_.tiles() ? this->position(tile) : pool_size();
  const bool forwards = tile > old.tile;
  if (forwards) {
    if (position < old.end || position > pool_size()) return false;
    const std::uint32_t moved = position - old.end;
    std::memmove(bytes_ + old.begin, bytes_ + old.end, moved);
    gap_ = {tile, old.begin + moved, position};
  } else {
    if (position < index_bytes(grid_) || position > old.begin) return false;
    const std::uint32_t moved = old.begin - position;
    std::memmove(bytes_ + old.end - moved, bytes_ + position, moved);
    gap_ = {tile, position, old.end - moved};
  }
  const auto group_from = [](std::uint32_t first) { return (first + kTilesPerGroup - 1) / kTilesPerGroup; };
  const std::uint32_t last = group_from(std::max(tile, old.tile));
  for (std::uint32_t index = group_from(std::min(tile, old.tile)); index < last; ++index) {
    const std::uint32_t from = group(index, old.tile);
    set_group(index, forwards ? from - gap_.size() : from + gap_.size());
  }
  return true;
}

bool TileIndex::replace(std::uint32_t tile, std::span<const std::byte> record) {
  const std::uint32_t old_size = size(tile);
  if (!move_gap(tile) || old_size > pool_size() - gap_.end || record.size() > gap_.size() + old_size) return false;
  std::memcpy(bytes_ + gap_.begin, record.data(), record.size());
  const std::uint32_t position = gap_.begin;
  gap_ = {tile + 1, position + static_cast<std::uint32_t>(record.size()), gap_.end + old_size};
  bytes_[sizes_at() + tile] = static_cast<std::byte>(record.size());
  if (tile % kTilesPerGroup == 0) set_group(tile / kTilesPerGroup, position);
  return true;
}

}  // namespace zstrip::detail
