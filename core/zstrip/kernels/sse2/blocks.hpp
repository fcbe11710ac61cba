// Scanning a triangle's box with SSE2 in blocks of four columns and two rows: each value of eight pixels in one or two
// registers, edge functions and channels modulo 2^16, depths modulo 2^32.
#pragma once

#include <algorithm>
#include <cstddef>

#include "zstrip/geometry/project.hpp"
#include "zstrip/kernels/sse2/fragments.hpp"
#include "zstrip/raster/plane.hpp"
#include "zstrip/raster/target.hpp"

#if ZSTRIP_HAS_SSE2

namespace zstrip::detail::blocks {

constexpr std::int32_t kBlockColumns = 4;
constexpr std::int32_t kBlockRows = 2;

/// Four cells or pixels in each of two rows.
struct InTwoRows {
  std::ptrdiff_t stride;  ///< to the second row

  __m128i load(const std::uint16_t* at) const {
    const __m128i upper = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(at));
    return _mm_castps_si128(_mm_loadh_pi(_mm_castsi128_ps(upper), reinterpret_cast<const __m64*>(at + stride)));
  }
  void store(std::uint16_t* at, __m128i values) const {
    _mm_storel_epi64(reinterpret_cast<__m128i*>(at), values);
    _mm_storeh_pi(reinterpret_cast<__m64*>(at + stride), _mm_castsi128_ps(values));
  }
};

/// Eight values of 16 bits in the pixels of a block, from their steps a pixel.
inline __m128i stepped_halves(__m128i start, __m128i step_x, __m128i step_y) {
  const __m128i columns = _mm_set_epi16(3, 2, 1, 0, 3, 2, 1, 0);
  const __m128i second_row = _mm_set_epi16(-1, -1, -1, -1, 0, 0, 0, 0);
  return _mm_add_epi16(start, _mm_add_epi16(_mm_mullo_epi16(step_x, columns), _mm_and_si128(step_y, second_row)));
}

inline __m128i in_all_halves(std::int32_t value) { return _mm_set1_epi16(static_cast<std::int16_t>(value)); }

inline std::int32_t pair_of(std::int32_t low, std::int32_t high) {
  return static_cast<std::int32_t>((static_cast<std::uint32_t>(high) << 16) |
                                   (static_cast<std::uint32_t>(low) & 0xFFFF));
}
inline __m128i in_all_pairs(std::int32_t low, std::int32_t high) { return _mm_set1_epi32(pair_of(low, high)); }

template <int word>
inline __m128i word_in_all(__m128i values) {
  return _mm_shuffle_epi32(values, word * 0x55);
}

template <int half>
inline __m128i half_in_all(__m128i values) {
  if constexpr (half < 4) return word_in_all<0>(_mm_shufflelo_epi16(values, half * 0x55));
  return word_in_all<2>(_mm_shufflehi_epi16(values, (half & 3) * 0x55));
}

inline __m128i place_of(const SnappedVertex& v) {
  std::int32_t pair;
  __builtin_memcpy(&pair, &v, sizeof pair);
  return _mm_cvtsi32_si128(pair);
}
inline __m128i place_of(const RasterVertex& v) { return _mm_cvtsi32_si128(pair_of(v.x, v.y)); }

/// The edges 2 -> 0, 0 -> 1 and 1 -> 2, the weights of vertices 1, 2 and 0, in a word each.
struct Edges {
  __m128i corners;  ///< where each ends: x, y
  __m128i steps;    ///< a sub-pixel to the right and down

  template <class Vertex>
  Edges(const Vertex& v0, const Vertex& v1, const Vertex& v2)
      : corners(_mm_unpacklo_epi64(_mm_unpacklo_epi32(place_of(v0), place_of(v1)), place_of(v2))) {
    const __m128i starts = _mm_shuffle_epi32(corners, _MM_SHUFFLE(3, 1, 0, 2));
    const __m128i along = _mm_sub_epi16(corners, starts);
    // To the right by dy, down by -dx.
    const __m128i swapped = _mm_shufflehi_epi16(_mm_shufflelo_epi16(along, 0xB1), 0xB1);
    steps = _mm_mullo_epi16(swapped, in_all_pairs(1, -1));
  }
  /// The edge functions at the centre of a pixel, without the fill rule.
  __m128i at(std::int32_t column, std::int32_t row) const {
    const __m128i centre = in_all_pairs(column * 16 + kPixelCentre, row * 16 + kPixelCentre);
    return _mm_madd_epi16(steps, _mm_sub_epi16(centre, corners));
  }
  /// PackedEdges::field of all.
  __m128i fields(__m128i exact) const {
    const __m128i not_top_left = _mm_srai_epi32(_mm_madd_epi16(steps, in_all_pairs(1 << 14, 1)), 31);
    return _mm_srai_epi32(_mm_add_epi32(exact, not_top_left), 4);
  }
};

/// An edge function / 16, and its step to the block below.
struct EdgeBlock {
  __m128i value, down;

  template <int edge>
  static EdgeBlock of(__m128i fields, __m128i steps) {
    const __m128i pairs = word_in_all<edge>(steps);
    const __m128i start = word_in_all<edge>(fields);
    const __m128i upper = _mm_madd_epi16(pairs, _mm_set_epi16(0, 3, 0, 2, 0, 1, 0, 0));
    const __m128i lower = _mm_madd_epi16(pairs, _mm_set_epi16(1, 3, 1, 2, 1, 1, 1, 0));
    const __m128i below = _mm_shufflehi_epi16(_mm_shufflelo_epi16(pairs, 0xF5), 0xF5);
    return {_mm_packs_epi32(_mm_add_epi32(upper, start), _mm_add_epi32(lower, start)), _mm_slli_epi16(below, 1)};
  }
  template <int edge>
  void move_right(__m128i steps) {
    const __m128i pairs = word_in_all<edge>(steps);
    const __m128i beside = _mm_shufflehi_epi16(_mm_shufflelo_epi16(pairs, 0xA0), 0xA0);
    value = _mm_add_epi16(value, _mm_slli_epi16(beside, 2));
  }
};

// What colours the pixels of blocks: a column() of them has the colour() of one and goes down to the next.

/// Pixels of one colour.
struct OneColour {
  __m128i pixels;

  const OneColour& column() const { return *this; }
  void move_right() {}
  __m128i colour() const { return pixels; }
  void go_down() const {}
};

/// A channel in 8.8 in the pixels of a block, and its steps a pixel.
struct ChannelBlock {
  __m128i value, step_x, step_y;

  void move_right() { value = _mm_add_epi16(value, _mm_slli_epi16(step_x, 2)); }
  void go_down() { value = _mm_add_epi16(value, _mm_slli_epi16(step_y, 1)); }
};
struct ChannelBlocks {
  ChannelBlock r, g, b;

  ChannelBlocks column() const { return *this; }
  void move_right() { r.move_right(), g.move_right(), b.move_right(); }
  __m128i colour() const { return rgb565_of_halves(r.value, g.value, b.value); }
  void go_down() { r.go_down(), g.go_down(), b.go_down(); }
};

/// A value of 32 bits in the pixels of a block, and its steps a pixel.
struct WordBlock {
  __m128i upper, lower, step_x, step_y;

  WordBlock(std::uint32_t start, std::uint32_t right, std::uint32_t down)
      : upper(stepped_words(start, right)), step_x(in_all_words(right)), step_y(in_all_words(down)) {
    lower = _mm_add_epi32(upper, step_y);
  }
  /// Their upper halves.
  __m128i halves() const { return upper_halves(upper, lower); }
  void move_right() { move(_mm_slli_epi32(step_x, 2)); }
  void go_down() { move(_mm_add_epi32(step_y, step_y)); }

 private:
  void move(__m128i by) { upper = _mm_add_epi32(upper, by), lower = _mm_add_epi32(lower, by); }
};
/// Channels in 16.16.
struct WordChannels {
  WordBlock r, g, b;

  WordChannels column() const { return *this; }
  void move_right() { r.move_right(), g.move_right(), b.move_right(); }
  __m128i colour() const { return rgb565_of_halves(r.halves(), g.halves(), b.halves()); }
  void go_down() { r.go_down(), g.go_down(), b.go_down(); }
};

/// The blocks of a triangle's box in a strip. They may go beyond the box, where the triangle covers nothing, but not
/// beyond the strip.
struct Blocks {
  const StripTarget& target;
  std::int32_t across, down;  ///< how many
  std::int32_t left, top;     ///< the first pixel of the first one

  Blocks(const StripTarget& strip, const Rect& box)
      : target(strip),
        across((box.width() + kBlockColumns - 1) >> 2),
        down((box.height() + kBlockRows - 1) >> 1),
        left(std::min(box.left, strip.area.right - across * kBlockColumns)),
        top(std::min(box.top, strip.area.bottom - down * kBlockRows)) {}

  bool fit() const { return left >= target.area.left && top >= target.area.top; }

  /// `exact`: Edges::at(left, top); `z`: depths of the first four pixels; `colours` of the first block.
  template <class Colours>
  [[gnu::always_inline]] void draw(const Edges& edges, __m128i exact, __m128i z, __m128i z_step_x, __m128i z_step_y,
                                   Colours colours) const {
    const __m128i fields = edges.fields(exact);
    EdgeBlock e[3] = {EdgeBlock::of<0>(fields, edges.steps), EdgeBlock::of<1>(fields, edges.steps),
                      EdgeBlock::of<2>(fields, edges.steps)};
    std::uint16_t* depth = target.depth_row(top) + (left - target.area.left);
    std::uint16_t* pixel = target.colour_row(top) + (left - target.area.left);
    // Alone, a column's values need not be kept: most small triangles have one.
    if (across == 1) return draw_column(e, z, z_step_y, colours, depth, pixel);
    for (std::int32_t column = across;;) {
      draw_column(e, z, z_step_y, colours, depth, pixel);
      if (--column == 0) return;
      e[0].move_right<0>(edges.steps);
      e[1].move_right<1>(edges.steps);
      e[2].move_right<2>(edges.steps);
      colours.move_right();
      z = _mm_add_epi32(z, _mm_slli_epi32(z_step_x, 2));
      depth += kBlockColumns;
      pixel += kBlockColumns;
    }
  }

 private:
  template <class Colours>
  [[gnu::always_inline]] void draw_column(const EdgeBlock (&e)[3], __m128i upper, __m128i z_step_y,
                                          const Colours& colours, std::uint16_t* depth, std::uint16_t* pixel) const {
    // Copies: compilers must assume that stores of lanes change any memory.
    const InTwoRows cells{target.depth_stride};
    const InTwoRows pixels{target.colour_stride};
    const __m128i z_down = _mm_add_epi32(z_step_y, z_step_y);
    __m128i e0 = e[0].value, e1 = e[1].value, e2 = e[2].value;
    __m128i lower = _mm_add_epi32(upper, z_step_y);
    auto column = colours.column();
    for (std::int32_t row = down;;) {
      const __m128i outside = _mm_srai_epi16(_mm_or_si128(_mm_or_si128(e0, e1), e2), 15);
      if (_mm_movemask_epi8(outside) != 0xFFFF) {
        // Code 0 is nearer than no cell.
        draw_fragments(cells, pixels, depth, pixel, _mm_andnot_si128(outside, upper_halves(upper, lower)),
                       [&] { return column.colour(); });
      }
      if (--row == 0) return;
      e0 = _mm_add_epi16(e0, e[0].down);
      e1 = _mm_add_epi16(e1, e[1].down);
      e2 = _mm_add_epi16(e2, e[2].down);
      upper = _mm_add_epi32(upper, z_down);
      lower = _mm_add_epi32(lower, z_down);
      column.go_down();
      depth += cells.stride * kBlockRows;
      pixel += pixels.stride * kBlockRows;
    }
  }
};

}  // namespace zstrip::detail::blocks

#endif
