// Small triangles in blocks: their planes from the edge functions, all three at once.
#include "zstrip/kernels/sse2/small_triangle.hpp"

#include <algorithm>

#include "zstrip/base/math.hpp"
#include "zstrip/kernels/small_scan.hpp"
#include "zstrip/kernels/sse2/blocks.hpp"
#include "zstrip/kernels/sse2/medium_triangle.hpp"

#if ZSTRIP_HAS_SSE2

namespace zstrip::detail {
namespace {

using namespace blocks;

__m128i channels_of(const Colour& colour) {
  std::int32_t bits;
  __builtin_memcpy(&bits, &colour, sizeof bits);
  return _mm_unpacklo_epi8(_mm_cvtsi32_si128(bits), _mm_setzero_si128());
}

/// Grows with y, then x.
std::int32_t order_of(__m128i place) { return _mm_cvtsi128_si32(place) ^ 0x8000; }

/// floor(a * b / 2^32) in each word, 0 <= b < 2^31.
__m128i multiply_high_by_positive(__m128i a, __m128i b) {
  const __m128i even = _mm_srli_epi64(_mm_mul_epu32(a, b), 32);
  const __m128i odd = _mm_and_si128(_mm_mul_epu32(_mm_srli_epi64(a, 32), b), _mm_set_epi32(-1, 0, -1, 0));
  // As an unsigned factor a negative one counts 2^32 more.
  return _mm_sub_epi32(_mm_or_si128(even, odd), _mm_and_si128(_mm_srai_epi32(a, 31), b));
}

/// The weights of vertices 1 and 2: their steps a pixel to the right and down, and where they start, each as a pair of
/// halves: 16 x 180 and 8100 at most.
__m128i weight_pairs(const Edges& edges, __m128i at_anchor) {
  const __m128i steps = _mm_shufflelo_epi16(edges.steps, _MM_SHUFFLE(3, 1, 2, 0));
  return _mm_unpacklo_epi64(_mm_slli_epi16(steps, 4), _mm_packs_epi32(at_anchor, at_anchor));
}

/// small_depth: step_x, step_y and the start less depth 0. `per_unit`: of edge function.
__m128i depth_plane(__m128i weights, std::uint32_t per_unit_1, std::uint32_t per_unit_2) {
  const __m128i both = _mm_unpacklo_epi16(_mm_cvtsi32_si128(static_cast<std::int32_t>(per_unit_1)),
                                          _mm_cvtsi32_si128(static_cast<std::int32_t>(per_unit_2)));
  // Both halves as signed factors: a lower one from 2^15 on counts 2^16 less.
  const __m128i low = word_in_all<0>(both);
  const __m128i high = _mm_sub_epi16(word_in_all<1>(both), _mm_srai_epi16(low, 15));
  return _mm_add_epi32(_mm_madd_epi16(weights, low), _mm_slli_epi32(_mm_madd_epi16(weights, high), 16));
}

/// SmallChannels' planes.
[[gnu::always_inline]] inline ChannelBlocks channel_blocks(__m128i weights, std::int32_t inverse_area,
                                                           const Colour* const (&colours)[3], std::int32_t first_column,
                                                           std::int32_t first_row) {
  const __m128i first = channels_of(*colours[0]);
  const __m128i differences = _mm_unpacklo_epi16(_mm_sub_epi16(channels_of(*colours[1]), first),
                                                 _mm_sub_epi16(channels_of(*colours[2]), first));
  const __m128i at_vertex = _mm_add_epi16(_mm_slli_epi16(first, 8), in_all_halves(128));
  const __m128i inverse = in_all_words(static_cast<std::uint32_t>(inverse_area));
  const auto channel = [&](__m128i difference, __m128i start) {
    const __m128i plane = multiply_high_by_positive(_mm_slli_epi32(_mm_madd_epi16(weights, difference), 9), inverse);
    const __m128i step_x = half_in_all<0>(plane);
    const __m128i step_y = half_in_all<2>(plane);
    start = _mm_add_epi16(start, half_in_all<4>(plane));
    if ((first_column | first_row) != 0) {
      start = _mm_add_epi16(start, _mm_add_epi16(_mm_mullo_epi16(step_x, in_all_halves(first_column)),
                                                 _mm_mullo_epi16(step_y, in_all_halves(first_row))));
    }
    return ChannelBlock{stepped_halves(start, step_x, step_y), step_x, step_y};
  };
  return {channel(word_in_all<0>(differences), half_in_all<0>(at_vertex)),
          channel(word_in_all<1>(differences), half_in_all<1>(at_vertex)),
          channel(word_in_all<2>(differences), half_in_all<2>(at_vertex))};
}

template <bool gouraud>
[[gnu::always_inline]] inline bool draw(const SmallTriangle& t, const Colour* const (&colours)[3],
                                        std::uint16_t flat_colour) {
  const Blocks blocks(t.target, t.box);
  if (!blocks.fit()) return false;
  const Edges edges(t.v0, t.v1, t.v2);
  const __m128i at_anchor = edges.at(t.anchor_x, t.anchor_y);
  const __m128i weights = weight_pairs(edges, at_anchor);
  const auto inverse_area = static_cast<std::int32_t>(quotient_31(static_cast<std::uint32_t>(t.area)));
  const auto per_unit = [&](const SnappedVertex& v) {
    const auto difference = static_cast<std::int32_t>(v.depth - t.v0.depth);
    return static_cast<std::uint32_t>(multiply_high_rounded(difference * 2, inverse_area));
  };
  const __m128i plane = depth_plane(weights, per_unit(t.v1), per_unit(t.v2));
  const __m128i step_x = word_in_all<0>(plane);
  const __m128i step_y = word_in_all<1>(plane);
  __m128i z = _mm_add_epi32(_mm_add_epi32(word_in_all<2>(plane), in_all_words(t.v0.depth)), multiples_0_to_3(step_x));
  __m128i exact = at_anchor;
  const std::int32_t first_column = blocks.left - t.anchor_x;
  const std::int32_t first_row = blocks.top - t.anchor_y;
  if ((first_column | first_row) != 0) {
    exact = edges.at(blocks.left, blocks.top);
    const auto sx = static_cast<std::uint32_t>(_mm_cvtsi128_si32(step_x));
    const auto sy = static_cast<std::uint32_t>(_mm_cvtsi128_si32(step_y));
    z = _mm_add_epi32(
        z, in_all_words(sx * static_cast<std::uint32_t>(first_column) + sy * static_cast<std::uint32_t>(first_row)));
  }
  if constexpr (gouraud) {
    blocks.draw(edges, exact, z, step_x, step_y,
                channel_blocks(weights, inverse_area, colours, first_column, first_row));
  } else {
    blocks.draw(edges, exact, z, step_x, step_y, OneColour{in_all_halves(flat_colour)});
  }
  return true;
}

}  // namespace

bool draw_small_flat_sse2(const SmallTriangle& triangle, std::uint16_t colour) {
  return draw<false>(triangle, {}, colour);
}

bool draw_small_gouraud_sse2(const SmallTriangle& triangle, const Colour* const (&colours)[3]) {
  return draw<true>(triangle, colours, 0);
}

std::uint32_t draw_small_run_sse2(const StripTarget& target, const SnappedVertex* vertices, const Colour* colours,
                                  std::uint32_t first_vertex, const Triangle* triangles, std::uint32_t count) {
  const Rect& strip = target.area;
  for (std::uint32_t i = 0; i < count; ++i) {
    std::uint32_t a = triangles[i].a - first_vertex, b = triangles[i].b - first_vertex,
                  c = triangles[i].c - first_vertex;
    const __m128i at_a = place_of(vertices[a]), at_b = place_of(vertices[b]), at_c = place_of(vertices[c]);
    // Assembler::narrow_area.
    const __m128i to_b = _mm_mullo_epi16(_mm_shufflelo_epi16(_mm_sub_epi16(at_b, at_a), 0xB1), in_all_pairs(1, -1));
    const std::int32_t area = _mm_cvtsi128_si32(_mm_madd_epi16(_mm_sub_epi16(at_c, at_a), to_b));
    if (area <= 0) continue;
    const __m128i least = _mm_min_epi16(_mm_min_epi16(at_a, at_b), at_c);
    const __m128i greatest = _mm_max_epi16(_mm_max_epi16(at_a, at_b), at_c);
    const std::int32_t low = _mm_cvtsi128_si32(least), high = _mm_cvtsi128_si32(greatest);
    const std::int32_t min_x = static_cast<std::int16_t>(low), min_y = low >> 16;
    const std::int32_t max_x = static_cast<std::int16_t>(high), max_y = high >> 16;
    const Rect box{std::max(min_x >> 4, strip.left), std::max(min_y >> 4, strip.top), std::min(max_x >> 4, strip.right),
                   std::min(max_y >> 4, strip.bottom)};
    if (box.empty()) continue;
    // rotate_to_first: by y, then x.
    const std::int32_t order_a = order_of(at_a), order_b = order_of(at_b), order_c = order_of(at_c);
    const std::uint32_t first = a;
    if (order_b < order_a && order_b < order_c) {
      a = b, b = c, c = first;
    } else if (order_c < order_a) {
      a = c, c = b, b = first;
    }
    const Colour* const of_vertices[3] = {colours + a, colours + b, colours + c};
    if (!is_small(max_x - min_x, max_y - min_y, vertices[a], vertices[b], vertices[c])) {
      if (!draw_medium_gouraud_sse2({target, vertices[a], vertices[b], vertices[c], area}, of_vertices)) return i;
    } else if (!draw<true>({target, vertices[a], vertices[b], vertices[c], area, min_x >> 4, min_y >> 4, box},
                           of_vertices, 0)) {
      return i;
    }
  }
  return count;
}

}  // namespace zstrip::detail

#endif
