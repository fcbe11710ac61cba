// Bounds of the depth in 8x8 tiles of a strip's z-buffer and a pyramid of farthest depths above them: what is hidden
// for certain, without a look at every cell (Greene, Kass and Miller, "Hierarchical Z-Buffer Visibility", 1993).
//
// Depth in the z-buffer only grows, greater is nearer, unless a material has a test of its own: then what it touches is
// forgotten. So a farthest depth that was true stays a bound; it is found again, lazily, when a tile is tested
// into which as many fragments have been drawn since as it has cells.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "zstrip/plan/visibility_bytes.hpp"
#include "zstrip/view.hpp"
#include "zstrip/visibility.hpp"

namespace zstrip::detail {

class DepthBounds {
 public:
  /// The tiles of a z-buffer that was just cleared; `area` in raster pixels, `memory` of
  /// depth_bounds_bytes(area.width(), area.height()).
  void begin(std::byte* memory, const Rect& area, const std::uint16_t* cells);

  /// Whether every cell of `box` (raster pixels inside the area, not empty) holds a code that is not smaller than
  /// `nearest`: nothing there can be seen.
  bool hides(const Rect& box, std::uint32_t nearest, VisibilityStatistics* counts);
  /// Whether every cell of `box` holds a code smaller than `farthest`: all there is seen.
  bool lies_behind(const Rect& box, std::uint32_t farthest, VisibilityStatistics* counts) const;
  /// Fragments with codes up to `nearest` may be drawn into `box`.
  void cover(const Rect& box, std::uint32_t nearest);
  /// Whatever may be drawn into `box`, farther codes too: nothing is known of its tiles until they are read again.
  void forget(const Rect& box);

  /// Calls draw(first, length) for the parts of a run of pixels that no tile hides: column `first` from the run's left
  /// end. The depth of pixel i is value + i * step, 16.16 codes, modulo 2^32.
  template <class Draw>
  void for_each_shown(std::int32_t row, std::int32_t left, std::int32_t length, std::uint32_t value, std::uint32_t step,
                      VisibilityStatistics* counts, const Draw& draw) {
    const std::int32_t y = (row - area_.top) >> kDepthTileShift;
    std::int32_t shown = 0;  // pixels before `at` that wait to be drawn
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

  /// Farthest code known of the tile with this raster pixel.
  std::uint16_t farthest_at(std::int32_t column, std::int32_t row) const {
    return tiles_[((row - area_.top) >> kDepthTileShift) * across_[0] + ((column - area_.left) >> kDepthTileShift)]
        .farthest;
  }

 private:
  struct Tile {
    std::uint16_t farthest;  ///< at most the farthest code of the tile's cells
    std::uint16_t nearest;   ///< at least the nearest
    std::uint8_t pending;    ///< cells that were covered since `farthest` was found; 255: that many or more
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
  /// Nodes (level > 0) or tiles that hold the box; inclusive.
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
  /// Finds the farthest code of a tile again, and of the nodes above it.
  void read(Tile& tile, std::int32_t x, std::int32_t y, VisibilityStatistics* counts);
  std::uint32_t farthest_below(int level, std::int32_t x, std::int32_t y) const;

  Rect area_{};
  const std::uint16_t* cells_ = nullptr;
  Tile* tiles_ = nullptr;
  std::uint16_t* nodes_[kMaxLevels] = {};  ///< of each level above the tiles; [0] is not used
  std::int32_t across_[kMaxLevels] = {}, down_[kMaxLevels] = {};
  int levels_ = 0;
};

}  // namespace zstrip::detail
