// A background that is drawn once and kept compressed, with depth and colour. Frames of moving objects are drawn over
// it, only in the tiles that changed:
//     layer.reset(memory, view); for each strip of the background: draw_strip, layer.keep(frame, strip, pixels)
//     each frame: renderer.begin_frame(moving things); layer.move_to(renderer.frame().bounds());
//                 while (layer.next(area, cells)) { layer.restore(area, ...); renderer.draw_over(area, ...); send area
//                 }
// Both frames must have the same depth format and the same camera, with Camera::fixed_depth_range. Otherwise their
// depths cannot be compared.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip/frame.hpp"
#include "zstrip/store/colour_store.hpp"
#include "zstrip/store/depth_store.hpp"
#include "zstrip/store/dirty_tiles.hpp"

namespace zstrip {

/// Not safe for two threads at once.
class StaticLayer {
 public:
  /// Lent by the caller until the layer is reset or destroyed. Real scenes need only a fraction of
  /// store_bytes_worst(width, height); docs/performance.md has figures.
  struct Memory {
    std::span<std::byte> depth;      ///< pool of the depth store
    std::span<std::byte> colour;     ///< pool of the colour store
    std::span<std::uint32_t> dirty;  ///< dirty_tile_words(width, height)
  };

  /// Makes the background empty, and marks all tiles dirty. Error::view_size; Error::store_full if a part of the memory
  /// is too small even for an empty background.
  Status reset(const Memory& memory, const View& view);

  /// Keeps the strip that was drawn last: `pixels` as draw_strip left them, and the frame's depth. Errors:
  /// strip_rows: there is no such strip. not_begun: another strip was drawn last. depth_effects: the depth format has
  /// no 16-bit cells, or the frame has sub-ranges or several samples a pixel. store_range: another view, another format
  /// than PixelFormat::rgb565, or a strip that does not begin and end at borders of the 8x8 tiles (or of the picture).
  /// pixels_too_small, pixels_misaligned. store_full: a pool is full. Then only some of the strip's tiles are new; keep
  /// the whole background again with larger pools.
  Status keep(Frame frame, std::uint16_t strip, std::span<const std::byte> pixels);

  /// Sets the bounds of the moving objects. Marks the tiles of these bounds and of the previous call's dirty.
  void move_to(const Rect& bounds);
  /// Marks all tiles dirty.
  void invalidate();

  /// Takes a rectangle of whole dirty tiles that has at most `cells` cells (>= 64). Returns false if no dirty tile is
  /// left. The rectangles do not overlap. Tiles that are not taken before the next move_to remain dirty.
  bool next(Rect& area, std::uint32_t cells);

  /// Reads the background of a rectangle of whole tiles: area.width() * area.height() pixels and codes, without gaps.
  /// Error::store_range if the rectangle is not of whole tiles, Error::pixels_too_small, or a store's error.
  Status restore(const Rect& area, std::span<std::uint16_t> pixels, std::span<std::uint16_t> depth) const;

  /// Returns the depth store, for example to see how full it is.
  const DepthStore& depth_store() const { return depth_; }
  /// Returns the colour store, for example to see how full it is.
  const ColourStore& colour_store() const { return colour_; }

 private:
  bool between_tiles(const Rect& area) const;

  DepthStore depth_;
  ColourStore colour_;
  DirtyTiles dirty_;
  std::uint16_t width_ = 0, height_ = 0;
  Rect last_{};     ///< the last argument of move_to
  Rect pending_{};  ///< the part of a large rectangle that next() has not returned yet
};

}  // namespace zstrip
