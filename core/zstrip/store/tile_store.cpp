// Stores of tiles. This file checks ranges; the index and the codec check bytes.
#include "zstrip/store/tile_store.hpp"

#include <array>

namespace zstrip::detail {
namespace {

constexpr std::uint32_t kMaxPool = 0x7FFFFFFF;  // positions and sums of them stay below 2^32

/// The part of a row of tiles that lies in rows top..bottom - 1; `whole` if it is the whole row of tiles.
struct RowsInTile {
  std::uint32_t first, last;  ///< `last` is exclusive
  bool whole;

  RowsInTile(std::uint32_t top, std::uint32_t bottom, std::uint32_t ty, std::uint32_t tile_height)
      : first(top > ty * kTileSide ? top - ty * kTileSide : 0),
        last(std::min(bottom - ty * kTileSide, tile_height)),
        whole(first == 0 && last == tile_height) {}
};

template <typename To, typename From>
void copy_rows(const TileView<To>& to, const TileView<From>& from) {
  for (std::uint32_t y = 0; y < from.height; ++y) std::copy_n(from.row(y), from.width, to.row(y));
}

}  // namespace

Status TileReader::open(std::span<const std::byte> blob) {
  index_ = {};
  const auto byte = [&blob](std::size_t at) { return std::to_integer<std::uint32_t>(blob[at]); };
  const Status damaged{.error = Error::store_damaged, .purpose = codec_->purpose};
  if (blob.size() < kStoreHeaderBytes || blob.size() > kMaxPool) return damaged;
  if (byte(0) != 'z' || byte(1) != 's' || byte(2) != kStoreVersion || byte(3) != codec_->kind) return damaged;
  const TileGrid grid{byte(4) | byte(5) << 8, byte(6) | byte(7) << 8};
  if (grid.width - 1 >= kMaxViewSize || grid.height - 1 >= kMaxViewSize) return damaged;
  if (blob.size() < index_bytes(grid)) return damaged;
  const auto end = static_cast<std::uint32_t>(blob.size());
  index_ = TileIndex(blob, grid, {grid.tiles(), end, end});
  return {};
}

Status TileReader::check_rows(std::uint32_t top, std::uint32_t rows) const {
  const std::uint32_t height = grid().height;
  if (top <= height && rows <= height - top) return {};
  return {.error = Error::store_range, .purpose = codec_->purpose, .needed = top + rows, .available = height};
}

Status TileReader::decode(std::uint32_t tile, std::uint32_t position, const TileView<std::uint16_t>& cells) const {
  std::span<const std::byte> record;
  if (index_.record(tile, position, record) && codec_->decode(record, cells)) return {};
  return {.error = Error::store_damaged, .purpose = codec_->purpose, .needed = tile};
}

Status TileReader::read_tile(std::uint32_t tx, std::uint32_t ty, std::uint16_t* cells, std::uint32_t stride) const {
  if (!grid().has(tx, ty)) return {.error = Error::store_range, .purpose = codec_->purpose};
  const std::uint32_t tile = ty * grid().columns() + tx;
  return decode(tile, index_.position(tile), {cells, stride, grid().tile_width(tx), grid().tile_height(ty)});
}

Status TileReader::read_rows(const RowsView<std::uint16_t>& rows) const {
  if (const Status status = check_rows(rows.top, rows.rows); !status) return status;
  const std::uint32_t bottom = rows.top + rows.rows;
  std::uint16_t* out = rows.cells;
  for (std::uint32_t ty = rows.top / kTileSide; ty * kTileSide < bottom; ++ty) {
    const std::uint32_t height = grid().tile_height(ty);
    const RowsInTile part(rows.top, bottom, ty, height);
    std::uint32_t tile = ty * grid().columns();
    std::uint32_t position = index_.position(tile);
    for (std::uint32_t tx = 0; tx < grid().columns(); ++tx, position = index_.next(tile, position), ++tile) {
      const std::uint32_t width = grid().tile_width(tx);
      std::uint16_t* const to = out + tx * kTileSide;
      if (part.whole) {
        if (const Status status = decode(tile, position, {to, rows.stride, width, height}); !status) return status;
        continue;
      }
      std::array<std::uint16_t, kTileCells> cells;
      if (const Status status = decode(tile, position, {cells.data(), kTileSide, width, height}); !status) {
        return status;
      }
      copy_rows(TileView<std::uint16_t>{to, rows.stride, width, part.last - part.first},
                TileView<const std::uint16_t>{cells.data() + part.first * kTileSide, kTileSide, width,
                                              part.last - part.first});
    }
    out += (part.last - part.first) * rows.stride;
  }
  return {};
}

Status TileReader::validate() const {
  std::uint32_t expected = index_bytes(grid());
  for (std::uint32_t tile = 0; tile < grid().tiles(); ++tile) {
    if (tile == index_.gap().tile) expected = index_.gap().end;
    const std::uint32_t tx = tile % grid().columns(), ty = tile / grid().columns();
    const Status damaged{.error = Error::store_damaged, .purpose = codec_->purpose, .needed = tile};
    if (tile % kTilesPerGroup == 0 && index_.position(tile) != expected) return damaged;
    std::array<std::uint16_t, kTileCells> cells;
    const Status status =
        decode(tile, expected, {cells.data(), kTileSide, grid().tile_width(tx), grid().tile_height(ty)});
    if (!status) return status;
    expected += index_.size(tile);
    if (tile + 1 == index_.gap().tile && expected > index_.gap().begin) return damaged;
  }
  return {};
}

Status TileStore::reset(std::span<std::byte> pool, std::uint32_t width, std::uint32_t height) {
  index_ = {};
  if (width - 1 >= kMaxViewSize || height - 1 >= kMaxViewSize) return {.error = Error::view_size};
  const TileGrid grid{width, height};
  const auto usable = pool.first(std::min<std::size_t>(pool.size(), kMaxPool));
  if (usable.size() < index_bytes(grid)) {
    return {.error = Error::store_full,
            .purpose = codec_->purpose,
            .needed = index_bytes(grid),
            .available = static_cast<std::uint32_t>(usable.size())};
  }
  index_ = TileIndex(usable, grid, codec_->kind);
  return {};
}

Status TileStore::write(std::uint32_t tile, const TileView<const std::uint16_t>& cells) {
  std::array<std::byte, kMaxTileRecord> record;
  const std::uint32_t size = codec_->encode(cells, record);
  if (size > index_.gap().size() + index_.size(tile)) {
    return {.error = Error::store_full,
            .purpose = codec_->purpose,
            .needed = bytes_used() - index_.size(tile) + size,
            .available = static_cast<std::uint32_t>(index_.pool().size())};
  }
  if (index_.replace(tile, std::span<const std::byte>(record).first(size))) return {};
  return {.error = Error::store_damaged, .purpose = codec_->purpose, .needed = tile};
}

Status TileStore::write_tile(std::uint32_t tx, std::uint32_t ty, const std::uint16_t* cells, std::uint32_t stride) {
  if (!grid().has(tx, ty)) return {.error = Error::store_range, .purpose = codec_->purpose};
  return write(ty * grid().columns() + tx, {cells, stride, grid().tile_width(tx), grid().tile_height(ty)});
}

Status TileStore::write_rows(const RowsView<const std::uint16_t>& rows) {
  if (const Status status = check_rows(rows.top, rows.rows); !status) return status;
  const std::uint32_t bottom = rows.top + rows.rows;
  const std::uint16_t* in = rows.cells;
  for (std::uint32_t ty = rows.top / kTileSide; ty * kTileSide < bottom; ++ty) {
    const std::uint32_t height = grid().tile_height(ty);
    const RowsInTile part(rows.top, bottom, ty, height);
    for (std::uint32_t tx = 0; tx < grid().columns(); ++tx) {
      const std::uint32_t width = grid().tile_width(tx);
      TileView<const std::uint16_t> from{in + tx * kTileSide, rows.stride, width, part.last - part.first};
      std::array<std::uint16_t, kTileCells> cells;
      if (!part.whole) {
        if (const Status status = read_tile(tx, ty, cells.data(), kTileSide); !status) return status;
        copy_rows(TileView<std::uint16_t>{cells.data() + part.first * kTileSide, kTileSide, width, from.height}, from);
        from = {cells.data(), kTileSide, width, height};
      }
      if (const Status status = write(ty * grid().columns() + tx, from); !status) return status;
    }
    in += (part.last - part.first) * rows.stride;
  }
  return {};
}

std::uint32_t TileStore::bytes_used() const {
  return static_cast<std::uint32_t>(index_.pool().size()) - index_.gap().size();
}

std::span<const std::byte> TileStore::blob() {
  if (grid().tiles() == 0 || !index_.move_gap(grid().tiles())) return {};
  return index_.pool().first(index_.gap().begin);
}

}  // namespace zstrip::detail
