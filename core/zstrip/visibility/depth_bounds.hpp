// Bounds of the depth in the 8x8 tiles of a strip's z-buffer, and a pyramid of farthest depths above them. They find
// hidden boxes without reading every cell (Greene, Kass and Miller, "Hierarchical Z-Buffer Visibility", 1993).
//
// Greater codes are nearer, and codes in the z-buffer only grow, unless a material has a depth test of its own: then
// the bounds of the tiles that it touches are forgotten. So a farthest depth that was once exact stays a bound. It is
// computed again only when a tile is tested after as many fragments as it has cells were drawn into it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "zstrip/view.hpp"
#include "zstrip/visibility/memory.hpp"
#include "zstrip/visibility/options.hpp"

namespace zstrip::detail {

class DepthBounds {
 public:
  /// Begins with the tiles of a z-buffer that was just cleared. `area` in raster pixels; `memory` has
  /// depth_bounds_bytes(area.width(), area.height()).
  void begin(std::byte* memory, const Rect& area, const std::uint16_t* cells);

  /// True if every cell of `box` (raster pixels inside the area, not empty) holds a code of at least `nearest`, so that
  /// nothing in it is visible.
  bool hides(const Rect& box, std::uint32_t nearest, VisibilityStatistics* counts);
  /// True if every cell of `box` holds a code smaller than `farthest`, so that everything in it is visible.
  bool lies_behind(const Rect& box, std::uint32_t farthest, VisibilityStatistics* counts) const;
  /// Records that fragments with codes up to `nearest` may be drawn into `box`.
  void cover(const Rect& box, std::uint32_t nearest);
  /// Records that fragments with any codes may be drawn into `box`: nothing is known about its tiles until they are
  /// read again.
  void forget(const Rect& box);

  /// Calls draw(first, length) for the parts of a run of pixels that no tile hides; `first` counts from the run's left
  /// end. The depth of pixel i is value + i * step, 16.16 codes, modulo 2^32.
  template <class Draw>
  void for_each_shown(std::int32_t row, std::int32_t left, std::int32_t length, std::uint32_t value, std::uint32_t step,
                      VisibilityStatistics* counts, const Draw& draw) {
    const std::int32_t y = (row - area_.top) >> kDepthTileShift;
    std::int32_t shown = 0;  // visible pixels before `at` that are not yet drawn
    std::int32_t at = 0;
    while (at < length) {
      const std::int32_t column = left + at - area_.left;
      const std::int32_t part = std::min(length - at, 8 - (column & 7));
      const std::uint32_t first = value + step * static_cast<std::uint32_t>(at);
      const std::uint32_t last = first + step * static_cast<std::uint32_t>(part - 1);
      const std::uint32_t nearest = std::max(first, last) >> 16;
      Tile& tile = tile_at(column >> kDepthTileShift, y);
      if (tile_hides(tile, column >> kDepthTileShift, y, nearest, counts)) {
        if (counts != nullptr) counts->run_pixels += static_cast<std::uint32_t>(part);
        if (shown != 0) draw(at - shown, shown);
        shown = 0;
      } else {
        add(tile, static_cast<std::uint32_t>(part), nearest);
        shown += part;
      }
      at += part;
    }
    if (shown != 0) draw(length - shown, shown);
  }

  /// Returns the farthest code known for the tile of this raster pixel.
  std::uint16_t farthest_at(std::int32_t column, std::int32_t row) const {
    return tiles_[((row - area_.top) >> kDepthTileShift) * across_[0] + ((column - area_.left) >> kDepthTileShift)]
        .farthest;
  }

 private:
  struct Tile {
    std::uint16_t farthest;  ///< not greater than the farthest code of the tile's cells
    std::uint16_t nearest;   ///< not smaller than the nearest code of the tile's cells
    std::uint8_t pending;    ///< cells that were covered since `farthest` was computed; 255: that many or more
    std::uint8_t unused;
  };
  static_assert(sizeof(Tile) == kDepthTileBytes);
  static constexpr std::uint8_t kWorthReading = 64;
  static constexpr int kMaxLevels = 11;  // 4096 pixels, 512 tiles, 256 .. 1 nodes

  Tile& tile_at(std::int32_t x, std::int32_t y) { return tiles_[y * across_[0] + x]; }
  static void add(Tile& tile, std::uint32_t cells, std::uint32_t nearest) {
    tile.pending = static_cast<std::uint8_t>(std::min<std::uint32_t>(255, tile.pending + cells));
    tile.nearest = static_cast<std::uint16_t>(std::max<std::uint32_t>(tile.nearest, nearest));
  }
  /// Returns the nodes (level > 0) or tiles that contain the box; inclusive.
  Rect nodes_of(const Rect& box, int level) const {
    const std::uint32_t shift = kDepthTileShift + static_cast<std::uint32_t>(level);
    return {(box.left - area_.left) >> shift, (box.top - area_.top) >> shift, (box.right - 1 - area_.left) >> shift,
            (box.bottom - 1 - area_.top) >> shift};
  }
  bool tile_hides(Tile& tile, std::int32_t x, std::int32_t y, std::uint32_t nearest, VisibilityStatistics* counts) {
    if (counts != nullptr) ++counts->comparisons;
    if (tile.farthest >= nearest) return true;
    if (tile.pending < kWorthReading || nearest > tile.nearest) return false;
    read(tile, x, y, counts);
    return tile.farthest >= nearest;
  }
  bool level_hides(const Rect& nodes, int level, std::uint32_t nearest, VisibilityStatistics* counts);
  /// Computes the farthest code of a tile again, and those of the nodes above it.
  void read(Tile& tile, std::int32_t x, std::int32_t y, VisibilityStatistics* counts);
  std::uint32_t farthest_below(int level, std::int32_t x, std::int32_t y) const;

  Rect area_{};
  const std::uint16_t* cells_ = nullptr;
  Tile* tiles_ = nullptr;
  std::uint16_t* nodes_[kMaxLevels] = {};  ///< nodes of each level above the tiles; [0] is not used
  std::int32_t across_[kMaxLevels] = {}, down_[kMaxLevels] = {};
  int levels_ = 0;
};

[[gnu::noinline]] inline void DepthBounds::begin(std::byte* memory, const Rect& area, const std::uint16_t* cells) {
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

[[gnu::noinline]] inline bool DepthBounds::level_hides(const Rect& nodes, int level, std::uint32_t nearest,
                                                       VisibilityStatistics* counts) {
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

[[gnu::noinline]] inline bool DepthBounds::hides(const Rect& box, std::uint32_t nearest, VisibilityStatistics* counts) {
  constexpr std::int32_t kMaxNodes = 16;  // of a level that is searched completely
  int level = 0;
  Rect nodes = nodes_of(box, 0);
  while (level + 1 < levels_ && (nodes.width() > 1 || nodes.height() > 1)) nodes = nodes_of(box, ++level);
  for (;; nodes = nodes_of(box, --level)) {
    if ((nodes.width() + 1) * (nodes.height() + 1) > kMaxNodes) return false;
    if (level_hides(nodes, level, nearest, counts)) return true;
    if (level == 0) return false;
  }
}

[[gnu::noinline]] inline bool DepthBounds::lies_behind(const Rect& box, std::uint32_t farthest,
                                                       VisibilityStatistics* counts) const {
  const Rect tiles = nodes_of(box, 0);
  for (std::int32_t y = tiles.top; y <= tiles.bottom; ++y) {
    for (std::int32_t x = tiles.left; x <= tiles.right; ++x) {
      if (counts != nullptr) ++counts->comparisons;
      if (tiles_[y * across_[0] + x].nearest >= farthest) return false;
    }
  }
  return true;
}

[[gnu::noinline]] inline void DepthBounds::cover(const Rect& box, std::uint32_t nearest) {
  const Rect tiles = nodes_of(box, 0);
  for (std::int32_t y = tiles.top; y <= tiles.bottom; ++y) {
    const std::int32_t top = std::max(box.top, area_.top + 8 * y);
    const std::int32_t bottom = std::min(box.bottom, area_.top + 8 * y + 8);
    for (std::int32_t x = tiles.left; x <= tiles.right; ++x) {
      const std::int32_t left = std::max(box.left, area_.left + 8 * x);
      const std::int32_t right = std::min(box.right, area_.left + 8 * x + 8);
      // A triangle covers half of its box.
      add(tile_at(x, y), static_cast<std::uint32_t>((right - left) * (bottom - top) + 1) / 2, nearest);
    }
  }
}

[[gnu::noinline]] inline void DepthBounds::forget(const Rect& box) {
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

[[gnu::noinline]] inline void DepthBounds::read(Tile& tile, std::int32_t x, std::int32_t y,
                                                VisibilityStatistics* counts) {
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

[[gnu::noinline]] inline std::uint32_t DepthBounds::farthest_below(int level, std::int32_t x, std::int32_t y) const {
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
