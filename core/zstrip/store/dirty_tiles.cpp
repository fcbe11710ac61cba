// A bitmap of tiles, and the rectangles that are taken from it.
#include "zstrip/store/dirty_tiles.hpp"

#include <algorithm>
#include <bit>

namespace zstrip {

Status DirtyTiles::reset(std::span<std::uint32_t> words, std::uint32_t width, std::uint32_t height) {
  words_ = {};
  grid_ = {};
  first_row_ = 0;
  if (width - 1 >= kMaxViewSize || height - 1 >= kMaxViewSize) return {.error = Error::view_size};
  const std::uint32_t needed = dirty_tile_words(width, height);
  if (words.size() < needed) {
    return {
        .error = Error::store_full, .needed = 4 * needed, .available = 4 * static_cast<std::uint32_t>(words.size())};
  }
  words_ = words.first(needed);
  grid_ = {width, height};
  std::fill(words_.begin(), words_.end(), 0);
  first_row_ = grid_.rows();
  return {};
}

void DirtyTiles::mark(const Rect& cells) {
  const auto cut = [](std::int32_t at, std::uint32_t size) {
    return static_cast<std::uint32_t>(std::clamp(at, std::int32_t{0}, static_cast<std::int32_t>(size)));
  };
  const std::uint32_t left = cut(cells.left, grid_.width), right = cut(cells.right, grid_.width),
                      top = cut(cells.top, grid_.height), bottom = cut(cells.bottom, grid_.height);
  if (left >= right || top >= bottom) return;
  first_row_ = std::min(first_row_, top / kTileSide);
  for (std::uint32_t ty = top / kTileSide; ty * kTileSide < bottom; ++ty) {
    set(left / kTileSide, (right + kTileSide - 1) / kTileSide, ty, true);
  }
}

bool DirtyTiles::marked(std::uint32_t tx, std::uint32_t ty) const {
  return grid_.has(tx, ty) && (words_[ty * words_per_row() + tx / 32] >> tx % 32 & 1) != 0;
}

bool DirtyTiles::take(Rect& cells) {
  const std::uint32_t columns = grid_.columns(), rows = grid_.rows();
  std::uint32_t first = columns;
  while (first_row_ < rows && (first = find(0, first_row_, true)) == columns) ++first_row_;
  if (first_row_ >= rows) return false;
  const std::uint32_t last = find(first, first_row_, false);
  std::uint32_t ty = first_row_;
  // Rows below are added only if they have the same run: a longer run would be cut into pieces.
  do {
    set(first, last, ty, false);
    ++ty;
  } while (ty < rows && marked(first, ty) && find(first, ty, false) == last && (first == 0 || !marked(first - 1, ty)));
  cells = {static_cast<std::int32_t>(first * kTileSide), static_cast<std::int32_t>(first_row_ * kTileSide),
           static_cast<std::int32_t>(std::min(last * kTileSide, grid_.width)),
           static_cast<std::int32_t>(std::min(ty * kTileSide, grid_.height))};
  return true;
}

std::uint32_t DirtyTiles::find(std::uint32_t tx, std::uint32_t ty, bool marked) const {
  const std::uint32_t columns = grid_.columns();
  while (tx < columns) {
    const std::uint32_t word = words_[ty * words_per_row() + tx / 32];
    const std::uint32_t candidates = (marked ? word : ~word) >> tx % 32;
    if (candidates != 0) return std::min(tx + static_cast<std::uint32_t>(std::countr_zero(candidates)), columns);
    tx = (tx / 32 + 1) * 32;
  }
  return columns;
}

void DirtyTiles::set(std::uint32_t first, std::uint32_t last, std::uint32_t ty, bool marked) {
  while (first < last) {
    const std::uint32_t end = std::min(last, (first / 32 + 1) * 32);
    const std::uint32_t bits = (0xFFFFFFFFU >> (32 - (end - first))) << first % 32;
    std::uint32_t& word = words_[ty * words_per_row() + first / 32];
    word = marked ? word | bits : word & ~bits;
    first = end;
  }
}

}  // namespace zstrip
