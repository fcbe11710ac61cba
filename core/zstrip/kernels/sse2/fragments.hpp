// Eight fragments at once with SSE2: depth test of z16, write of depth and colour.
#pragma once

#include "zstrip/kernels/sse2/intrinsics.hpp"

#if ZSTRIP_HAS_SSE2

#include <cstdint>

namespace zstrip::detail {

/// A word in all lanes.
inline __m128i in_all_words(std::uint32_t value) { return _mm_set1_epi32(static_cast<std::int32_t>(value)); }

/// 0, 1, 2 and 3 times what all words are.
inline __m128i multiples_0_to_3(__m128i step) {
  const __m128i odd = _mm_and_si128(step, _mm_set_epi32(-1, 0, -1, 0));
  const __m128i upper = _mm_and_si128(_mm_add_epi32(step, step), _mm_set_epi32(-1, -1, 0, 0));
  return _mm_add_epi32(odd, upper);
}

/// start, start + step, start + 2 step, start + 3 step.
inline __m128i stepped_words(std::uint32_t start, std::uint32_t step) {
  return _mm_add_epi32(in_all_words(start), multiples_0_to_3(in_all_words(step)));
}

/// The upper halves of eight words.
inline __m128i upper_halves(__m128i first_four, __m128i last_four) {
  return _mm_packs_epi32(_mm_srai_epi32(first_four, 16), _mm_srai_epi32(last_four, 16));
}

/// Eight cells or pixels in a row.
struct InOneRow {
  static __m128i load(const std::uint16_t* at) { return _mm_loadu_si128(reinterpret_cast<const __m128i*>(at)); }
  static void store(std::uint16_t* at, __m128i values) { _mm_storeu_si128(reinterpret_cast<__m128i*>(at), values); }
};
/// Four, and none in the upper lanes.
struct HalfRow {
  static __m128i load(const std::uint16_t* at) { return _mm_loadl_epi64(reinterpret_cast<const __m128i*>(at)); }
  static void store(std::uint16_t* at, __m128i values) { _mm_storel_epi64(reinterpret_cast<__m128i*>(at), values); }
};

/// RGB565 of channels in 8.8.
inline __m128i rgb565_of_halves(__m128i r, __m128i g, __m128i b) {
  const __m128i red = _mm_and_si128(r, _mm_set1_epi16(static_cast<std::int16_t>(0xF800)));
  const __m128i green = _mm_and_si128(_mm_srli_epi16(g, 5), _mm_set1_epi16(0x07E0));
  return _mm_or_si128(_mm_or_si128(red, green), _mm_srli_epi16(b, 11));
}

/// Draws the fragments whose code is greater than their cell. `cells` and `pixels` load and store eight, or four, from
/// an address on; colour_of() gives the fragments' colours.
template <class Cells, class Pixels, class ColourOf>
[[gnu::always_inline]] inline void draw_fragments(const Cells& cells, const Pixels& pixels, std::uint16_t* depth,
                                                  std::uint16_t* pixel, __m128i codes, const ColourOf& colour_of) {
  const __m128i old = cells.load(depth);
  const __m128i nearer = _mm_subs_epu16(codes, old);  // by how much; 0 where it is not
  cells.store(depth, _mm_add_epi16(old, nearer));
  const __m128i hidden = _mm_cmpeq_epi16(nearer, _mm_setzero_si128());
  const __m128i kept = _mm_and_si128(hidden, pixels.load(pixel));
  pixels.store(pixel, _mm_or_si128(kept, _mm_andnot_si128(hidden, colour_of())));
}
template <class Place, class ColourOf>
[[gnu::always_inline]] inline void draw_fragments(const Place& place, std::uint16_t* depth, std::uint16_t* pixel,
                                                  __m128i codes, const ColourOf& colour_of) {
  draw_fragments(place, place, depth, pixel, codes, colour_of);
}

}  // namespace zstrip::detail

#endif
