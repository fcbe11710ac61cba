// A background that is drawn once and kept compressed, depth and colour. Frames of what moves are drawn over it, in
// the tiles that changed and nowhere else:
//     layer.reset(memory, view); for each strip of the background: draw_strip, layer.keep(frame, strip, pixels)
//     each frame: renderer.begin_frame(moving things); layer.move_to(renderer.frame().bounds());
//                 while (layer.next(area, cells)) { layer.restore(area, ...); renderer.draw_over(area, ...); send area
//                 }
// Both frames must have the same camera, with Camera::fixed_depth_range, and the same depth format, or depths could not
// be compared.
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
  /// Lent by the caller until the layer is reset or gone. Scenes take a fraction of store_bytes_worst(width, height);
  /// docs/performance.md has figures.
  struct Memory {
    std::span<std::byte> depth;      ///< pool of the depth store
    std::span<std::byte> colour;     ///< pool of the colour store
    std::span<std::uint32_t> dirty;  ///< dirty_tile_words(width, height)
  };

  /// An empty background, all of whose tiles are dirty. Error::view_size; Error::store_full if a part of the memory has
  /// no room even for an empty one.
  Status reset(const Memory& memory, const View& view);

  /// Keeps the strip that was drawn last: `pixels` as draw_strip left them, and the frame's depth. Error::strip_rows if
  /// there is no such strip; Error::not_begun if another one was drawn last; Error::depth_effects for depth that has no
  /// 16-bit cells, or sub-ranges, or several samples a pixel; Error::store_range for another view or another format
  /// than PixelFormat::rgb565, and if the strip does not begin and end between tiles of 8x8 (or at the picture's
  /// border); Error::pixels_too_small, Error::pixels_misaligned. Error::store_full if a pool is full: some of the
  /// strip's tiles are then new, others not; keep the whole background again with larger pools.
  Status keep(Frame frame, std::uint16_t strip, std::span<const std::byte> pixels);

  /// What moves lies in `bounds` now; its tiles and those of the last call are to be drawn again.
  void move_to(const Rect& bounds);
  /// All tiles are to be drawn again.
  void invalidate();

  /// Takes a rectangle of whole tiles that is to be drawn again and has at most `cells` cells (>= 64); false if none is
  /// left. They do not overlap; what is not taken before the next move_to comes again.
  bool next(Rect& area, std::uint32_t cells);

  /// The background of a rectangle of whole tiles: area.width() * area.height() pixels and codes, without gaps.
  /// Error::store_range if it is not of whole tiles, Error::pixels_too_small, or a store's error.
  Status restore(const Rect& area, std::span<std::uint16_t> pixels, std::span<std::uint16_t> depth) const;

  /// To see how full it is.
  const DepthStore& depth_store() const { return depth_; }
  /// To see how full it is.
  const ColourStore& colour_store() const { return colour_; }

 private:
  bool between_tiles(const Rect& area) const;

  DepthStore depth_;
  ColourStore colour_;
  DirtyTiles dirty_;
  std::uint16_t width_ = 0, height_ = 0;
  Rect last_{};     ///< what move_to got last
  Rect pending_{};  ///< what next() has still to hand out of a rectangle that was too large
};

}  // namespace zstrip
