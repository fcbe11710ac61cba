// Building, asking and raising the bounds of tiles and pyramid; see depth_bounds.hpp.
#include "zstrip/visibility/depth_bounds.hpp"

namespace zstrip::detail {

void DepthBounds::begin(std::byte* memory, const Rect& area, const std::uint16_t* cells) {
  area_ = area;
  cells_ = cells;
  tiles_ = reinterpret_cast<Tile*>(memory);
  std::int32_t across = (area.width() + 7) >> kDepthTileShift;
  std::int32_t down = (area.height() + 7) >> kDepthTileShift;
  auto* next = reinterpret_cast<std::uint16_t*>(memory + across * down * std::int32_t{kDepthTileBytes});
  for (levels_ = 0;; ++levels_) {
    across_[levels_] = across;
    down_[levels_] = down;
    if (levels_ != 0) {
      nodes_[levels_] = next;
      next += across * down;
    }
    if (across <= 1 && down <= 1) break;
    across = (across + 1) / 2;
    down = (down + 1) / 2;
  }
  ++levels_;
  __builtin_memset(memory, 0, static_cast<std::size_t>(reinterpret_cast<std::byte*>(next) - memory));
}

bool DepthBounds::level_hides(const Rect& nodes, int level, std::uint32_t nearest, VisibilityStatistics* counts) {
  for (std::int32_t y = nodes.top; y <= nodes.bottom; ++y) {
    for (std::int32_t x = nodes.left; x <= nodes.right; ++x) {
      if (level == 0) {
        if (!tile_hides(tile_at(x, y), x, y, nearest, counts)) return false;
      } else {
        if (counts != nullptr) ++counts->comparisons;
        if (nodes_[level][y * across_[level] + x] < nearest) return false;
      }
    }
  }
  return true;
}

bool DepthBounds::hides(const Rect& box, std::uint32_t nearest, VisibilityStatistics* counts) {
  constexpr std::int32_t kMaxNodes = 16;  // of a level that is looked at in full
  int level = 0;
  Rect nodes = nodes_of(box, 0);
  while (level + 1 < levels_ && (nodes.width() > 1 || nodes.height() > 1)) nodes = nodes_of(box, ++level);
  for (;; nodes = nodes_of(box, --level)) {
    if ((nodes.width() + 1) * (nodes.height() + 1) > kMaxNodes) return false;
    if (level_hides(nodes, level, nearest, counts)) return true;
    if (level == 0) return false;
  }
}

bool DepthBounds::lies_behind(const Rect& box, std::uint32_t farthest, VisibilityStatistics* counts) const {
  const Rect tiles = nodes_of(box, 0);
  for (std::int32_t y = tiles.top; y <= tiles.bottom; ++y) {
    for (std::int32_t x = tiles.left; x <= tiles.right; ++x) {
      if (counts != nullptr) ++counts->comparisons;
      if (tiles_[y * across_[0] + x].nearest >= farthest) return false;
    }
  }
  return true;
}

void DepthBounds::cover(const Rect& box, std::uint32_t nearest) {
  const Rect tiles = nodes_of(box, 0);
  for (std::int32_t y = tiles.top; y <= tiles.bottom; ++y) {
    const std::int32_t top = std::max(box.top, area_.top + 8 * y);
    const std::int32_t bottom = std::min(box.bottom, area_.top + 8 * y + 8);
    for (std::int32_t x = tiles.left; x <= tiles.right; ++x) {
      const std::int32_t left = std::max(box.left, area_.left + 8 * x);
      const std::int32_t right = std::min(box.right, area_.left + 8 * x + 8);
      // A triangle is half of its box.
      add(tile_at(x, y), static_cast<std::uint32_t>((right - left) * (bottom - top) + 1) / 2, nearest);
    }
  }
}

void DepthBounds::forget(const Rect& box) {
  for (int level = 0; level < levels_; ++level) {
    const Rect nodes = nodes_of(box, level);
    for (std::int32_t y = nodes.top; y <= nodes.bottom; ++y) {
      for (std::int32_t x = nodes.left; x <= nodes.right; ++x) {
        if (level == 0) {
          tile_at(x, y) = {0, 0xFFFF, 255, 0};
        } else {
          nodes_[level][y * across_[level] + x] = 0;
        }
      }
    }
  }
}

void DepthBounds::read(Tile& tile, std::int32_t x, std::int32_t y, VisibilityStatistics* counts) {
  const std::int32_t columns = std::min<std::int32_t>(8, area_.width() - 8 * x);
  const std::int32_t rows = std::min<std::int32_t>(8, area_.height() - 8 * y);
  const std::uint16_t* cells = cells_ + 8 * y * area_.width() + 8 * x;
  std::uint16_t farthest = 0xFFFF;
  for (std::int32_t row = 0; row < rows && farthest != 0; ++row, cells += area_.width()) {
    if (counts != nullptr) counts->cells_read += static_cast<std::uint32_t>(columns);
    farthest = std::min(farthest, *std::min_element(cells, cells + columns));
  }
  tile.pending = 0;
  if (farthest <= tile.farthest) return;
  tile.farthest = farthest;
  for (int level = 1; level < levels_; ++level) {
    x >>= 1, y >>= 1;
    const std::uint32_t bound = farthest_below(level, x, y);
    std::uint16_t& node = nodes_[level][y * across_[level] + x];
    if (bound <= node) return;
    node = static_cast<std::uint16_t>(bound);
  }
}

std::uint32_t DepthBounds::farthest_below(int level, std::int32_t x, std::int32_t y) const {
  const int below = level - 1;
  std::uint32_t farthest = 0xFFFF;
  for (std::int32_t row = 2 * y; row < std::min(2 * y + 2, down_[below]); ++row) {
    for (std::int32_t column = 2 * x; column < std::min(2 * x + 2, across_[below]); ++column) {
      const std::int32_t at = row * across_[below] + column;
      farthest = std::min<std::uint32_t>(farthest, below == 0 ? tiles_[at].farthest : nodes_[below][at]);
    }
  }
  return farthest;
}

}  // namespace zstrip::detail
