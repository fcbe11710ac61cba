// Scans a triangle's box in blocks of four columns and two rows: each value of eight pixels is in one or two registers,
// edge functions and channels modulo 2^16, depths modulo 2^32.
#pragma once

#include <algorithm>
#include <cstddef>

#include "zstrip/geometry/project.hpp"
#include "zstrip/kernels/vector/fragments.hpp"
#include "zstrip/pixels/plane.hpp"
#include "zstrip/pixels/target.hpp"

#if ZSTRIP_HAS_VECTORS

namespace zstrip::detail::vectors {

constexpr std::int32_t kBlockColumns = 4;
constexpr std::int32_t kBlockRows = 2;

/// Loads and stores four cells or pixels in each of two rows.
struct InTwoRows {
  std::ptrdiff_t stride;  ///< distance to the second row

  Halves load(const std::uint16_t* at) const { return load_4_and_4(at, at + stride); }
  void store(std::uint16_t* at, Halves values) const {
    store_4(at, values);
    store_upper_4(at + stride, values);
  }
};

inline Words place_of(const SnappedVertex& v) {
  std::uint32_t pair;
  __builtin_memcpy(&pair, &v, sizeof pair);
  return in_first_word(pair);
}

/// The smallest rectangles around triangles, one in each word: pairs of x and y.
struct Boxes {
  Halves least, greatest;

  Boxes(Words a, Words b, Words c)
      : least(signed_min(signed_min(as_halves(a), as_halves(b)), as_halves(c))),
        greatest(signed_max(signed_max(as_halves(a), as_halves(b)), as_halves(c))) {}
  /// These return the first pixels, and those after the last ones.
  Halves first() const { return arithmetically_right(least, 4); }
  Halves end() const { return arithmetically_right(greatest, 4); }
  /// Returns the box in the first word.
  Rect first_box() const {
    const auto low = static_cast<std::int32_t>(as_words(first())[0]);
    const auto high = static_cast<std::int32_t>(as_words(end())[0]);
    return {static_cast<std::int16_t>(low), low >> 16, static_cast<std::int16_t>(high), high >> 16};
  }
};

/// The edges 2 -> 0, 0 -> 1 and 1 -> 2, the weights of vertices 1, 2 and 0, each in a word.
struct Edges {
  Halves corners;  ///< end of each edge: x, y
  Halves steps;    ///< steps of a sub-pixel to the right and down

  Edges(const SnappedVertex& v0, const SnappedVertex& v1, const SnappedVertex& v2) {
    const Words ends = first_words(place_of(v0), place_of(v1), place_of(v2));
    corners = as_halves(ends);
    // Edge functions grow by dy to the right and by -dx downwards.
    steps = swapped_in_pairs(corners - as_halves(rotated(ends))) * in_all_pairs(1, -1);
  }
  /// Returns the edge functions at the centre of a pixel, without the fill rule.
  Words at(std::int32_t column, std::int32_t row) const {
    return sums_of_products(steps, in_all_pairs(column * 16 + kPixelCentre, row * 16 + kPixelCentre) - corners);
  }
  /// Returns PackedEdges::field of all edges.
  Words fields(Words exact) const {
    return arithmetically_right(exact + arithmetically_right(lower_then_upper(steps), 31), 4);
  }
};

/// An edge function / 16, and its step to the block below.
struct EdgeBlock {
  Halves value, down;

  template <int edge>
  static EdgeBlock of(Words fields, Halves steps) {
    return {stepped_edge<edge>(fields, steps), high_half_in_all<edge, 1>(steps)};
  }
  template <int edge>
  void move_right(Halves steps) {
    value += low_half_in_all<edge, 2>(steps);
  }
};

// The classes below colour the pixels of blocks: column() returns a column's colour() and goes down.

struct OneColour {
  Halves pixels;

  const OneColour& column() const { return *this; }
  void move_right() {}
  Halves colour() const { return pixels; }
  void go_down() const {}
};

/// A channel in 8.8 in the pixels of a block, and its steps to the next blocks to the right and down.
struct ChannelBlock {
  Halves value, right, down;

  void move_right() { value += right; }
  void go_down() { value += down; }
};
struct ChannelBlocks {
  ChannelBlock r, g, b;

  ChannelBlocks column() const { return *this; }
  void move_right() { r.move_right(), g.move_right(), b.move_right(); }
  Halves colour() const { return rgb565_of_halves(r.value, g.value, b.value); }
  void go_down() { r.go_down(), g.go_down(), b.go_down(); }
};

/// A value of 32 bits in the pixels of a block, and its steps a pixel.
struct WordBlock {
  Words upper, step_x, step_y;  ///< values of the upper row

  /// Returns the block for value `number` of four.
  template <int number>
  static WordBlock of(Words starts, Words steps_x, Words steps_y) {
    const Words right = word_in_all<number>(steps_x), down = word_in_all<number>(steps_y);
    return {word_in_all<number>(starts) + multiples_0_to_3(right), right, down};
  }
  Halves halves() const { return upper_halves(upper, upper + step_y); }
  void move_right() { upper += step_x << 2; }
  void go_down() { upper += step_y + step_y; }
};
/// Channels in 16.16.
struct WordChannels {
  WordBlock r, g, b;

  WordChannels column() const { return *this; }
  void move_right() { r.move_right(), g.move_right(), b.move_right(); }
  Halves colour() const { return rgb565_of_halves(r.halves(), g.halves(), b.halves()); }
  void go_down() { r.go_down(), g.go_down(), b.go_down(); }
};

/// The blocks of a triangle's box in a strip. They may extend beyond the box, where the triangle covers nothing, but
/// not beyond the strip.
struct Blocks {
  const StripTarget& target;
  std::int32_t across, down;  ///< number of blocks
  std::int32_t left, top;     ///< the first pixel of the first block

  Blocks(const StripTarget& strip, const Rect& box)
      : target(strip),
        across((box.width() + kBlockColumns - 1) >> 2),
        down((box.height() + kBlockRows - 1) >> 1),
        left(std::min(box.left, strip.area.right - across * kBlockColumns)),
        top(std::min(box.top, strip.area.bottom - down * kBlockRows)) {}

  bool fit() const { return left >= target.area.left && top >= target.area.top; }

  /// `exact`: Edges::at(left, top); `z`: depths of the first four pixels; `colours` of the first block.
  template <class Colours>
  [[gnu::always_inline]] void draw(const Edges& edges, Words exact, Words z, Words z_step_x, Words z_step_y,
                                   Colours colours) const {
    const Words fields = edges.fields(exact);
    EdgeBlock e[3] = {EdgeBlock::of<0>(fields, edges.steps), EdgeBlock::of<1>(fields, edges.steps),
                      EdgeBlock::of<2>(fields, edges.steps)};
    std::uint16_t* depth = target.depth_row(top) + (left - target.area.left);
    std::uint16_t* pixel = target.colour_row(top) + (left - target.area.left);
    // A single column's values need not be stored, and most small triangles have one column.
    if (across == 1) return draw_column(e, z, z_step_y, colours, depth, pixel);
    for (std::int32_t column = across;;) {
      draw_column(e, z, z_step_y, colours, depth, pixel);
      if (--column == 0) return;
      e[0].move_right<0>(edges.steps);
      e[1].move_right<1>(edges.steps);
      e[2].move_right<2>(edges.steps);
      colours.move_right();
      z += z_step_x << 2;
      depth += kBlockColumns;
      pixel += kBlockColumns;
    }
  }

 private:
  template <class Colours>
  [[gnu::always_inline]] void draw_column(const EdgeBlock (&e)[3], Words upper, Words z_step_y, const Colours& colours,
                                          std::uint16_t* depth, std::uint16_t* pixel) const {
    // These are copies, because compilers must assume that storing a lane changes any memory.
    const InTwoRows cells{target.depth_stride};
    const InTwoRows pixels{target.colour_stride};
    const Words z_down = z_step_y + z_step_y;
    Halves e0 = e[0].value, e1 = e[1].value, e2 = e[2].value;
    auto column = colours.column();
    for (std::int32_t row = down;;) {
      const Halves outside = arithmetically_right(e0 | e1 | e2, 15);
      if (any_clear(outside)) {
        // A fragment of code 0 is never nearer than a cell.
        draw_fragments(cells, pixels, depth, pixel, ~outside & upper_halves(upper, upper + z_step_y),
                       [&] { return column.colour(); });
      }
      if (--row == 0) return;
      e0 += e[0].down;
      e1 += e[1].down;
      e2 += e[2].down;
      upper += z_down;
      column.go_down();
      depth += cells.stride * kBlockRows;
      pixel += pixels.stride * kBlockRows;
    }
  }
};

}  // namespace zstrip::detail::vectors

#endif
