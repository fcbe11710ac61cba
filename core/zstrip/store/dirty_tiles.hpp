// Which tiles of a static layer must be decoded again: those that moving things covered or cover now.
#pragma once

#include <cstdint>
#include <span>

#include "zstrip/status.hpp"
#include "zstrip/store/store_bytes.hpp"
#include "zstrip/view.hpp"

namespace zstrip {

/// A set of tiles in the caller's memory. A frame marks the rectangles of the last frame and its own, then takes
/// rectangles of tiles until there are none: each marked tile lies in exactly one of them.
class DirtyTiles {
 public:
  /// No tile is marked. Error::view_size; Error::store_full if there are fewer than dirty_tile_words (`needed`,
  /// `available` in bytes).
  Status reset(std::span<std::uint32_t> words, std::uint32_t width, std::uint32_t height);

  /// Marks every tile that has a cell in `cells`, relative to the rectangle; what lies outside it does not count.
  void mark(const Rect& cells);
  bool marked(std::uint32_t tx, std::uint32_t ty) const;
  /// Takes marked tiles that form a rectangle out of the set: the first row of tiles that has any, the first run of
  /// them there, and as many rows below as have the same run. In cells, cut to the rectangle; false if none is left.
  bool take(Rect& cells);

 private:
  std::uint32_t words_per_row() const { return (grid_.columns() + 31) / 32; }
  /// The first tile from `tx` on that is marked, or not marked; columns() if there is none.
  std::uint32_t find(std::uint32_t tx, std::uint32_t ty, bool marked) const;
  void set(std::uint32_t first, std::uint32_t last, std::uint32_t ty, bool marked);

  std::span<std::uint32_t> words_;
  TileGrid grid_;
  std::uint32_t first_row_ = 0;  ///< none above it is marked
};

}  // namespace zstrip
