// Draws four small triangles at once: each lane of a vector belongs to one of them. Computes their planes, then the
// pixels of a cell of each, four columns and four rows, and transposes them to blocks of four columns and two rows.
#pragma once

#include <cstdint>

#include "zstrip/base/division.hpp"
#include "zstrip/kernels/vector/vector.hpp"
#include "zstrip/pixels/small_scan.hpp"

#if ZSTRIP_HAS_VECTORS

namespace zstrip::detail::vectors {

constexpr std::int32_t kCellSide = 4;  ///< pixels

/// The three corners of four triangles. Place, depth and colour of a corner are a word each.
struct FourCorners {
  Words place[3], depth[3], colour[3];

  /// Rotates the corners of each triangle so that the highest is first; if several are, the leftmost of them.
  /// `mirrors`: exchanges the other two in triangles that show their back face.
  template <bool gouraud>
  [[gnu::always_inline]] void turn(bool mirrors) {
    // Grows with y, then x.
    const auto order = [this](int i) { return place[i] ^ in_all_words(0x8000); };
    const Words a = order(0), b = order(1), c = order(2);
    const Words to_second = greater(a, b) & greater(c, b);
    const Words to_third = greater(a, c) & ~to_second;
    const auto turned = [&](Words(&of)[3]) {
      const Words a_b = of[0] ^ of[1], b_c = of[1] ^ of[2], all = a_b ^ of[2];
      of[0] ^= (a_b & to_second) ^ ((a_b ^ b_c) & to_third);
      of[1] ^= (b_c & to_second) ^ (a_b & to_third);
      of[2] = all ^ of[0] ^ of[1];
    };
    turned(place), turned(depth);
    if constexpr (gouraud) turned(colour);
    if (!mirrors) return;
    const auto side = [this](int i) { return as_halves(place[i]) - as_halves(place[0]); };
    const Words back =
        arithmetically_right(sums_of_products(side(2), swapped_in_pairs(side(1)) * in_all_pairs(1, -1)), 31);
    const auto exchange = [back](Words& x, Words& y) {
      const Words both = (x ^ y) & back;
      x ^= both, y ^= both;
    };
    exchange(place[1], place[2]), exchange(depth[1], depth[2]);
    if constexpr (gouraud) exchange(colour[1], colour[2]);
  }
};

/// A value and its steps a pixel. Lanes 0 to 3 are the triangles, and lanes 4 to 7 repeat them; those are two rows
/// lower in in_rows().
struct FourValues {
  Halves value, right, down;

  Halves in_rows() const { return value + ((down & Halves{0, 0, 0, 0, 0xFFFF, 0xFFFF, 0xFFFF, 0xFFFF}) << 1); }
  void move(Halves columns, Halves rows) { value += right * columns + down * rows; }
};

/// The pixels of four cells. Triangle i has its two upper rows in [i] and its two lower rows in [4 + i].
struct FourCells {
  struct Block {
    Halves codes;    ///< 0 if the pixel is not covered
    Halves colours;  ///< RGB565
  };
  Block blocks[8];
};

/// Transposes eight vectors: each column becomes one part of a block.
[[gnu::always_inline]] inline void transpose(const Halves (&from)[8], FourCells& to, Halves FourCells::Block::*part) {
  const auto shuffle = [](const Halves(&x)[8], Halves(&y)[8]) {
    y[0] = interleaved_low(x[0], x[4]), y[1] = interleaved_high(x[0], x[4]);
    y[2] = interleaved_low(x[1], x[5]), y[3] = interleaved_high(x[1], x[5]);
    y[4] = interleaved_low(x[2], x[6]), y[5] = interleaved_high(x[2], x[6]);
    y[6] = interleaved_low(x[3], x[7]), y[7] = interleaved_high(x[3], x[7]);
  };
  Halves a[8], b[8];
  shuffle(from, a);
  shuffle(a, b);
  shuffle(b, a);
  to.blocks[0].*part = a[0], to.blocks[1].*part = a[1], to.blocks[2].*part = a[2], to.blocks[3].*part = a[3];
  to.blocks[4].*part = a[4], to.blocks[5].*part = a[5], to.blocks[6].*part = a[6], to.blocks[7].*part = a[7];
}

/// Four small triangles. The first corner of each is the highest; if several are, the leftmost of them.
template <bool gouraud>
class FourTriangles {
 public:
  /// `anchor`: the centre of each triangle's first pixel.
  [[gnu::always_inline]] FourTriangles(const FourCorners& corners, Halves anchor) {
    const auto place = [&corners](int i) { return as_halves(corners.place[i]); };
    // Sides from the end of each edge to its start: an edge function grows by y to the right and by -x downwards.
    const Halves edge_1 = place(0) - place(2), edge_2 = place(1) - place(0);
    const auto across = [](Halves side) { return swapped_in_pairs(side) * in_all_pairs(-1, 1); };
    const Halves to_anchor = across(anchor - place(0));
    const Words area = sums_of_products(edge_1, across(edge_2));
    const Words at_1 = sums_of_products(edge_1, to_anchor), at_2 = sums_of_products(edge_2, to_anchor);
    const Words inverse{quotient_31(area[0]), quotient_31(area[1]), quotient_31(area[2]), quotient_31(area[3])};
    // The weights of vertices 1 and 2, in pairs.
    const Halves weights = lower_pairs(as_halves(at_1), as_halves(at_2));
    const Halves steps_x = upper_pairs(edge_1, edge_2), steps_y = Halves{} - lower_pairs(edge_1, edge_2);
    const Halves fields = edge_fields(weights, steps_x, steps_y);
    edges_[1] = {lower_twice(fields), lower_twice(steps_x), lower_twice(steps_y)};
    edges_[2] = {upper_twice(fields), upper_twice(steps_x), upper_twice(steps_y)};
    const Words at_0 = area - at_1 - at_2;
    edges_[0].right = Halves{} - (edges_[1].right + edges_[2].right);
    edges_[0].down = Halves{} - (edges_[1].down + edges_[2].down);
    edges_[0].value = edge_fields(narrowed(at_0, at_0), edges_[0].right, edges_[0].down);
    const Halves right = steps_x << 4, down = steps_y << 4;
    const auto& depth = corners.depth;
    const WordFactors per_unit(rounded_upper_products<1>(depth[1] - depth[0], inverse),
                               rounded_upper_products<1>(depth[2] - depth[0], inverse));
    z_ = settled(depth[0] + per_unit.sums(weights));
    z_right_ = settled(per_unit.sums(right)), z_down_ = settled(per_unit.sums(down));
    // Compares halves, because differences of whole depths need 33 bits.
    const auto near = [&depth](int i) {
      return (depth[0] >> 1) - (depth[i] >> 1) + in_all_words(kSmallDepthDifference / 2);
    };
    static_assert(kSmallDepthDifference == 1U << 29);
    far_ = ((near(1) | near(2)) >> 29) != Words{};

    if constexpr (gouraud) {
      const HalvesOfProducts per_area(inverse);
      const auto red_blue = [&corners](int i) { return as_halves(corners.colour[i] & in_all_words(0x00FF00FF)); };
      const auto green = [&corners](int i) { return as_halves((corners.colour[i] >> 8) & in_all_words(0xFF)); };
      const Halves red_blue_1 = red_blue(1) - red_blue(0), red_blue_2 = red_blue(2) - red_blue(0);
      const auto channel = [&](Halves differences, Halves at_corner) {
        const auto plane = [&](Halves weights_of) { return per_area.of(sums_of_products(weights_of, differences)); };
        return FourValues{at_corner + in_all_halves(128) + plane(weights), plane(right), plane(down)};
      };
      const Halves red_green = lower_twice(as_halves(corners.colour[0]));
      channels_[0] = channel(lower_pairs(red_blue_1, red_blue_2), red_green << 8);
      channels_[1] = channel(lower_pairs(green(1) - green(0), green(2) - green(0)), red_green & in_all_halves(0xFF00));
      channels_[2] = channel(upper_pairs(red_blue_1, red_blue_2), upper_twice(as_halves(corners.colour[0])) << 8);
    }
  }

  /// Returns a mask of the triangles whose depths differ too much for small triangles.
  Words far() const { return far_; }

  /// Moves by columns and rows, in pairs.
  void move(Halves pixels) {
    const Words columns = arithmetically_right(as_words(pixels) << 16, 16);
    const Words rows = arithmetically_right(as_words(pixels), 16);
    const Halves by_columns = narrowed(columns, columns), by_rows = narrowed(rows, rows);
    edges_[0].move(by_columns, by_rows), edges_[1].move(by_columns, by_rows), edges_[2].move(by_columns, by_rows);
    z_ += z_right_ * columns + z_down_ * rows;
    if constexpr (gouraud) {
      channels_[0].move(by_columns, by_rows), channels_[1].move(by_columns, by_rows);
      channels_[2].move(by_columns, by_rows);
    }
  }

  /// Draws the cells that begin at the anchors.
  [[gnu::always_inline]] void draw(FourCells& cells) const {
    Halves pixels[8];
    {
      const auto &a = edges_[0], &b = edges_[1], &c = edges_[2];
      const Halves at_a = a.in_rows(), at_b = b.in_rows(), at_c = c.in_rows();
      draw_codes(pixels, at_a, at_b, at_c, z_);
      draw_codes(pixels + 4, at_a + a.down, at_b + b.down, at_c + c.down, z_ + z_down_);
    }
    transpose(pixels, cells, &FourCells::Block::codes);
    if constexpr (gouraud) {
      const auto &r = channels_[0], &g = channels_[1], &b = channels_[2];
      const Halves at_r = r.in_rows(), at_g = g.in_rows(), at_b = b.in_rows();
      draw_colours(pixels, at_r, at_g, at_b);
      draw_colours(pixels + 4, at_r + r.down, at_g + g.down, at_b + b.down);
      transpose(pixels, cells, &FourCells::Block::colours);
    }
  }

 private:
  /// Computes the codes of four columns in a row, and in the row two below it.
  [[gnu::always_inline]] void draw_codes(Halves* to, Halves a, Halves b, Halves c, Words upper) const {
    Words lower = upper + (z_down_ << 1);
    const auto next = [&] {
      const Halves outside = arithmetically_right(a | b | c, 15);
      // A fragment of code 0 is never nearer than a cell.
      const Halves codes = settled(~outside & upper_halves(upper, lower));
      a += edges_[0].right, b += edges_[1].right, c += edges_[2].right;
      upper += z_right_, lower += z_right_;
      return codes;
    };
    to[0] = next(), to[1] = next(), to[2] = next(), to[3] = next();
  }
  [[gnu::always_inline]] void draw_colours(Halves* to, Halves r, Halves g, Halves b) const {
    const auto next = [&] {
      const Halves colours = settled(rgb565_of_halves(r, g, b));
      r += channels_[0].right, g += channels_[1].right, b += channels_[2].right;
      return colours;
    };
    to[0] = next(), to[1] = next(), to[2] = next(), to[3] = next();
  }
  /// Returns PackedEdges::field of edge functions that grow by `right` and `down` a sub-pixel.
  static Halves edge_fields(Halves exact, Halves right, Halves down) {
    return arithmetically_right(exact + arithmetically_right(right + right + arithmetically_right(down, 15), 15), 4);
  }
  static Halves lower_twice(Halves pairs) { return lower_halves(as_words(pairs), as_words(pairs)); }
  static Halves upper_twice(Halves pairs) { return upper_halves(as_words(pairs), as_words(pairs)); }

  FourValues edges_[3];
  Words z_, z_right_, z_down_, far_;
  FourValues channels_[3];
};

}  // namespace zstrip::detail::vectors

#endif
