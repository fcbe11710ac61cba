// The tiles of a static layer that must be decoded again, because moving objects covered them or cover them now.
#pragma once

#include <cstdint>
#include <span>

#include "zstrip/status.hpp"
#include "zstrip/store/store_bytes.hpp"
#include "zstrip/view.hpp"

namespace zstrip {

/// A set of tiles in the caller's memory. A frame marks the rectangles of the last frame and its own. Then it takes
/// rectangles of tiles until none is left: each marked tile lies in exactly one of them.
class DirtyTiles {
 public:
  /// Makes the set empty. Error::view_size; Error::store_full if there are fewer than dirty_tile_words (`needed`,
  /// `available` in bytes).
  Status reset(std::span<std::uint32_t> words, std::uint32_t width, std::uint32_t height);

  /// Marks every tile that has a cell in `cells`, relative to the rectangle; cells outside of the rectangle are
  /// ignored.
  void mark(const Rect& cells);
  bool marked(std::uint32_t tx, std::uint32_t ty) const;
  /// Takes a rectangle of marked tiles out of the set: the first run of marked tiles in the first row that has any, and
  /// all rows directly below with the same run. `cells` is in cells, cut to the rectangle. Returns false if no tile is
  /// left.
  bool take(Rect& cells);

 private:
  std::uint32_t words_per_row() const { return (grid_.columns() + 31) / 32; }
  /// Returns the first tile from `tx` on that is marked (or not marked); columns() if there is none.
  std::uint32_t find(std::uint32_t tx, std::uint32_t ty, bool marked) const;
  void set(std::uint32_t first, std::uint32_t last, std::uint32_t ty, bool marked);

  std::span<std::uint32_t> words_;
  TileGrid grid_;
  std::uint32_t first_row_ = 0;  ///< no row above it has a marked tile
};

}  // namespace zstrip
