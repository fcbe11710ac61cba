// The functions of SSE2 that kernels in vectors need in addition to operators. neon.hpp has the same functions.
#pragma once

#include <cstdint>

#include "zstrip/geometry/instance.hpp"
#include "zstrip/kernels/vector/types.hpp"
#include "zstrip/scene.hpp"

#if ZSTRIP_HAS_SSE2

// GCC's header includes <stdlib.h> for aligned allocation, which nothing here needs.
#if !defined(_MM_MALLOC_H_INCLUDED)
#define _MM_MALLOC_H_INCLUDED  // NOLINT(bugprone-reserved-identifier)
#endif
#include <emmintrin.h>

namespace zstrip::detail::vectors {

template <class Vector>
__m128i as_sse2(Vector vector) {
  return __builtin_bit_cast(__m128i, vector);
}

inline Halves load_8(const std::uint16_t* at) {
  return as_halves(_mm_loadu_si128(reinterpret_cast<const __m128i*>(at)));
}
inline void store_8(std::uint16_t* at, Halves values) {
  _mm_storeu_si128(reinterpret_cast<__m128i*>(at), as_sse2(values));
}
/// Loads four halves into the lower lanes; the upper lanes are 0.
inline Halves load_4(const std::uint16_t* at) {
  return as_halves(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(at)));
}
inline void store_4(std::uint16_t* at, Halves values) {
  _mm_storel_epi64(reinterpret_cast<__m128i*>(at), as_sse2(values));
}
/// Loads four halves into the lower and four into the upper lanes.
inline Halves load_4_and_4(const std::uint16_t* at, const std::uint16_t* upper_at) {
  const __m128 lower = _mm_castsi128_ps(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(at)));
  return as_halves(_mm_loadh_pi(lower, reinterpret_cast<const __m64*>(upper_at)));
}
inline void store_upper_4(std::uint16_t* at, Halves values) {
  _mm_storeh_pi(reinterpret_cast<__m64*>(at), _mm_castsi128_ps(as_sse2(values)));
}

/// Sets the first word; the other words may have any value.
inline Words in_first_word(std::uint32_t value) { return Words{value, 0, 0, 0}; }
/// Returns a colour's channels, one in each of the lower four halves.
inline Halves bytes_of(std::uint32_t word) {
  return as_halves(_mm_unpacklo_epi8(as_sse2(in_first_word(word)), _mm_setzero_si128()));
}

template <int word>
Words word_in_all(Words values) {
  return as_words(_mm_shuffle_epi32(as_sse2(values), word * 0x55));
}
template <int half>
Halves half_in_all(Halves values) {
  if constexpr (half < 4) {
    return as_halves(word_in_all<0>(as_words(_mm_shufflelo_epi16(as_sse2(values), half * 0x55))));
  } else {
    return as_halves(word_in_all<2>(as_words(_mm_shufflehi_epi16(as_sse2(values), (half & 3) * 0x55))));
  }
}
/// Copies a half into all halves, shifted left.
template <int half, int shift>
Halves half_in_all(Halves values) {
  return half_in_all<half>(values) << shift;
}
/// Copies a word's lower or upper half into all halves, shifted left.
template <int word, int shift>
Halves low_half_in_all(Halves values) {
  const __m128i pairs = as_sse2(word_in_all<word>(as_words(values)));
  return as_halves(_mm_shufflehi_epi16(_mm_shufflelo_epi16(pairs, 0xA0), 0xA0)) << shift;
}
template <int word, int shift>
Halves high_half_in_all(Halves values) {
  const __m128i pairs = as_sse2(word_in_all<word>(as_words(values)));
  return as_halves(_mm_shufflehi_epi16(_mm_shufflelo_epi16(pairs, 0xF5), 0xF5)) << shift;
}
/// Returns the first words of three vectors; the fourth word may have any value.
inline Words first_words(Words a, Words b, Words c) {
  return as_words(_mm_unpacklo_epi64(_mm_unpacklo_epi32(as_sse2(a), as_sse2(b)), as_sse2(c)));
}
/// Returns the third, first and second word of first_words.
inline Words rotated(Words three) { return as_words(_mm_shuffle_epi32(as_sse2(three), _MM_SHUFFLE(3, 1, 0, 2))); }
inline Halves swapped_in_pairs(Halves values) {
  return as_halves(_mm_shufflehi_epi16(_mm_shufflelo_epi16(as_sse2(values), 0xB1), 0xB1));
}
inline Halves upper_halves(Words first_four, Words last_four) {
  return as_halves(_mm_packs_epi32(_mm_srai_epi32(as_sse2(first_four), 16), _mm_srai_epi32(as_sse2(last_four), 16)));
}

/// Returns the lower halves of eight words, which must be in the range of signed halves.
inline Halves narrowed(Words first_four, Words last_four) {
  return as_halves(_mm_packs_epi32(as_sse2(first_four), as_sse2(last_four)));
}
inline Halves lower_halves(Words first_four, Words last_four) {
  return upper_halves(first_four << 16, last_four << 16);
}
/// These return words 0 and 2, or 1 and 3, of both vectors.
template <class Vector>
Words even_words(Vector first, Vector last) {
  return as_words(_mm_shuffle_ps(_mm_castsi128_ps(as_sse2(first)), _mm_castsi128_ps(as_sse2(last)), 0x88));
}
template <class Vector>
Words odd_words(Vector first, Vector last) {
  return as_words(_mm_shuffle_ps(_mm_castsi128_ps(as_sse2(first)), _mm_castsi128_ps(as_sse2(last)), 0xDD));
}
/// These pair the lower halves of each word of both vectors, or the upper halves.
inline Halves lower_pairs(Halves low, Halves high) {
  return as_halves((as_words(low) & in_all_words(0xFFFF)) | (as_words(high) << 16));
}
inline Halves upper_pairs(Halves low, Halves high) {
  return as_halves((as_words(low) >> 16) | (as_words(high) & in_all_words(0xFFFF0000)));
}
/// These alternate the halves of both vectors.
inline Halves interleaved_low(Halves a, Halves b) { return as_halves(_mm_unpacklo_epi16(as_sse2(a), as_sse2(b))); }
inline Halves interleaved_high(Halves a, Halves b) { return as_halves(_mm_unpackhi_epi16(as_sse2(a), as_sse2(b))); }
inline std::uint32_t upper_bits(Words words) {
  return static_cast<std::uint32_t>(_mm_movemask_ps(_mm_castsi128_ps(as_sse2(words))));
}

/// Returns 0, 1, 2 and 3 times the value that all words have.
inline Words multiples_0_to_3(Words step) {
  return (step & Words{0, 0xFFFFFFFF, 0, 0xFFFFFFFF}) + ((step + step) & Words{0, 0, 0xFFFFFFFF, 0xFFFFFFFF});
}
inline Halves unsigned_max(Halves a, Halves b) { return as_halves(_mm_subs_epu16(as_sse2(a), as_sse2(b))) + b; }
/// Converts channels in 8.8 to RGB565.
inline Halves rgb565_of_halves(Halves r, Halves g, Halves b) {
  return ((r & in_all_halves(0xF800)) | ((g >> 5) & in_all_halves(0x07E0))) | (b >> 11);
}
inline Halves signed_min(Halves a, Halves b) { return as_halves(_mm_min_epi16(as_sse2(a), as_sse2(b))); }
inline Halves signed_max(Halves a, Halves b) { return as_halves(_mm_max_epi16(as_sse2(a), as_sse2(b))); }
/// Returns `a` where the mask is set, and `b` elsewhere.
inline Halves chosen(Halves mask, Halves a, Halves b) {
  return (mask & a) | as_halves(_mm_andnot_si128(as_sse2(mask), as_sse2(b)));
}
/// Returns true if some half of the mask is clear.
inline bool any_clear(Halves mask) { return _mm_movemask_epi8(as_sse2(mask)) != 0xFFFF; }
inline bool any_set(Halves values) { return any_clear(as_halves(values == Halves{})); }

/// Returns the products of the lower halves of words plus those of the upper halves, signed.
inline Words sums_of_products(Halves a, Halves b) { return as_words(_mm_madd_epi16(as_sse2(a), as_sse2(b))); }
inline std::int32_t sum_of_products(Halves a, Halves b) { return static_cast<std::int32_t>(sums_of_products(a, b)[0]); }
/// Compares pairs: negative if the lower half is, or if the lower half is 0 and the upper half is negative.
inline Words lower_then_upper(Halves pairs) { return sums_of_products(pairs, in_all_pairs(1 << 14, 1)); }
/// Returns floor(a * b / 2^16), unsigned.
inline Halves upper_products_of_halves(Halves a, Halves b) {
  return as_halves(_mm_mulhi_epu16(as_sse2(a), as_sse2(b)));
}
/// Multiplies words by unsigned factors, which fill both halves of each word, modulo 2^32.
inline Words times_half(Words words, Halves factors) {
  return as_words(as_halves(words) * factors) + (as_words(upper_products_of_halves(as_halves(words), factors)) << 16);
}
inline std::uint32_t sum(Words words) {
  const Words pairs = words + as_words(_mm_shuffle_epi32(as_sse2(words), _MM_SHUFFLE(1, 0, 3, 2)));
  return (pairs + as_words(_mm_shuffle_epi32(as_sse2(pairs), _MM_SHUFFLE(2, 3, 0, 1))))[0];
}
/// Returns floor(a * b / 2^32), unsigned.
inline Words unsigned_upper_products(Words a, Words b) {
  const __m128i even = _mm_mul_epu32(as_sse2(a), as_sse2(b));
  const __m128i odd = _mm_mul_epu32(_mm_srli_epi64(as_sse2(a), 32), _mm_srli_epi64(as_sse2(b), 32));
  return as_words(_mm_or_si128(_mm_srli_epi64(even, 32), _mm_and_si128(odd, _mm_set_epi32(-1, 0, -1, 0))));
}

/// Returns floor((a << shift) * b / 2^32) for signed a and unsigned b; with NEON b < 2^31.
template <int shift>
Words upper_products(Words a, Words b) {
  // As an unsigned factor, a negative number is 2^32 too large.
  const Words factors = a << shift;
  return unsigned_upper_products(factors, b) - (arithmetically_right(factors, 31) & b);
}

/// These multiply words 0 and 2; the others may have any value. They return the products' lower words, and
/// upper_products<0>.
inline Words products_of_even(Words a, Words b) { return as_words(_mm_mul_epu32(as_sse2(a), as_sse2(b))); }
inline Words upper_products_of_even(Words a, Words b) {
  return as_words(_mm_srli_epi64(as_sse2(products_of_even(a, b)), 32)) - (arithmetically_right(a, 31) & b);
}

/// The factors of upper_products<9> of whose results only the lower halves are used.
class HalvesOfProducts {
 public:
  explicit HalvesOfProducts(Words factors)
      : even_(as_sse2(factors)),
        odd_(_mm_srli_epi64(even_, 32)),
        of_sign_even_(_mm_slli_epi64(_mm_mul_epu32(even_, _mm_set1_epi32(1)), 31)),
        of_sign_odd_(_mm_slli_epi64(odd_, 31)) {}
  /// Returns four results, in the lower and again in the upper lanes.
  Halves of(Words values) const {
    // Adds 2^31, so that the value is not negative.
    const __m128i all = as_sse2((values << 9) ^ in_all_words(0x80000000));
    const __m128i even = _mm_sub_epi64(_mm_mul_epu32(all, even_), of_sign_even_);
    const __m128i odd = _mm_sub_epi64(_mm_mul_epu32(_mm_srli_epi64(all, 32), odd_), of_sign_odd_);
    const __m128i four = _mm_unpackhi_epi32(_mm_unpacklo_epi16(even, odd), _mm_unpackhi_epi16(even, odd));
    return as_halves(_mm_unpacklo_epi64(four, four));
  }

 private:
  __m128i even_, odd_, of_sign_even_, of_sign_odd_;
};

/// Returns upper_products rounded to nearest.
template <int shift>
Words rounded_upper_products(Words a, Words b) {
  const __m128i half = _mm_set_epi32(0, INT32_MIN, 0, INT32_MIN);
  const Words factors = a << shift;
  const __m128i f = as_sse2(factors), g = as_sse2(b);
  const __m128i even = _mm_add_epi64(_mm_mul_epu32(f, g), half);
  const __m128i odd = _mm_add_epi64(_mm_mul_epu32(_mm_srli_epi64(f, 32), _mm_srli_epi64(g, 32)), half);
  return as_words(_mm_or_si128(_mm_srli_epi64(even, 32), _mm_and_si128(odd, _mm_set_epi32(-1, 0, -1, 0)))) -
         (arithmetically_right(factors, 31) & b);
}

/// Two factors for each word.
class WordFactors {
 public:
  WordFactors(Words first, Words second)
      : low_(lower_pairs(as_halves(first), as_halves(second))),
        // Both halves are signed factors: a lower half of 2^15 or more is 2^16 too small, which the upper one corrects.
        high_(upper_pairs(as_halves(first), as_halves(second)) - arithmetically_right(low_, 15)) {}
  /// Returns the first factors times the lower halves of `pairs` plus the second factors times the upper halves,
  /// signed, modulo 2^32.
  Words sums(Halves pairs) const { return sums_of_products(pairs, low_) + (sums_of_products(pairs, high_) << 16); }

 private:
  Halves low_, high_;
};

/// Returns stepped_halves of an edge function that fits a half, from its word, and its steps in a pair.
template <int edge>
Halves stepped_edge(Words starts, Halves steps) {
  const __m128i pairs = as_sse2(word_in_all<edge>(as_words(steps)));
  const __m128i start = as_sse2(word_in_all<edge>(starts));
  const __m128i upper = _mm_madd_epi16(pairs, _mm_set_epi16(0, 3, 0, 2, 0, 1, 0, 0));
  const __m128i lower = _mm_madd_epi16(pairs, _mm_set_epi16(1, 3, 1, 2, 1, 1, 1, 0));
  return as_halves(_mm_packs_epi32(_mm_add_epi32(upper, start), _mm_add_epi32(lower, start)));
}

/// The weights of vertices 1 and 2: words 0 and 1 are steps a pixel right and down, word 2 the value at the anchor.
class Weights {
 public:
  /// From Edges: steps are at most 16 x 180, and the value at the anchor at most 8100.
  Weights(Halves edge_steps, Words at_anchor) {
    const __m128i steps = _mm_shufflelo_epi16(as_sse2(edge_steps), _MM_SHUFFLE(3, 1, 2, 0));
    const __m128i starts = as_sse2(at_anchor);
    pairs_ = as_halves(_mm_unpacklo_epi64(_mm_slli_epi16(steps, 4), _mm_packs_epi32(starts, starts)));
  }
  /// Returns weights times these factors, modulo 2^32.
  Words sum(std::uint32_t of_1, std::uint32_t of_2) const {
    const Halves both = as_halves(_mm_unpacklo_epi16(as_sse2(in_first_word(of_1)), as_sse2(in_first_word(of_2))));
    // Both halves are signed factors: a lower half of 2^15 or more is 2^16 too small, which the upper one corrects.
    const Halves low = as_halves(word_in_all<0>(as_words(both)));
    const Halves high = as_halves(word_in_all<1>(as_words(both))) - arithmetically_right(low, 15);
    return sums_of_products(pairs_, low) + (sums_of_products(pairs_, high) << 16);
  }

  /// Signed halves of two vectors, in pairs.
  struct Factors {
    Halves pairs;
    Factors(Halves of_1, Halves of_2) : pairs(as_halves(_mm_unpacklo_epi16(as_sse2(of_1), as_sse2(of_2)))) {}
  };
  template <int half>
  Words sum(const Factors& factors) const {
    return sums_of_products(pairs_, as_halves(word_in_all<half>(as_words(factors.pairs))));
  }

 private:
  Halves pairs_;
};

/// Shifts four words right by `amount`, 0 .. 31, minus a number for each word, by multiplying with powers of two.
class FourShifts {
 public:
  /// Returns the power of two for a number.
  static std::uint32_t of(int number) { return std::uint32_t{1} << number; }

  explicit FourShifts(Words numbers) : powers_(numbers) {}
  /// Shifts signed values, -2^30 <= value < 2^30.
  Words arithmetically(Words values, int amount) const { return upper_products<1>(values, factors(amount)); }
  /// Shifts values below 2^31.
  Words logically(Words values, int amount) const { return unsigned_upper_products(values << 1, factors(amount)); }

 private:
  Words factors(int amount) const { return powers_ << (31 - amount); }

  Words powers_;
};

/// Four adjacent positions, for FormOfFour.
struct FourPositions {
  Halves xy, yz;  ///< two coordinates of a position in each word

  explicit FourPositions(const Position* p) {
    const auto pair = [](const std::int16_t& first) {
      std::uint32_t both;
      __builtin_memcpy(&both, &first, sizeof both);
      return both;
    };
    xy = as_halves(Words{pair(p[0].x), pair(p[1].x), pair(p[2].x), pair(p[3].x)});
    yz = as_halves(Words{pair(p[0].y), pair(p[1].y), pair(p[2].y), pair(p[3].y)});
  }
};

/// Computes LinearForm::at for a form for which fits_vector is true. A coefficient a is 2^16 high + low, both signed,
/// so that floor(a p / 2^16) is high p + floor(low p / 2^16).
class FormOfFour {
 public:
  explicit FormOfFour(const LinearForm& f)
      : offset_(in_all_words(static_cast<std::uint32_t>(f.offset))),
        high_xy_(in_all_pairs(high(f.x), high(f.y))),
        high_z_(in_all_pairs(0, high(f.z))),
        low_xy_(in_all_pairs(f.x, f.y)),
        low_z_(in_all_pairs(0, f.z)) {}

  Words at(const FourPositions& p) const {
    const auto rest = [](Halves a, Halves b) {
      return sums_of_products(as_halves(_mm_mulhi_epi16(as_sse2(a), as_sse2(b))), in_all_halves(1));
    };
    const Words whole = sums_of_products(p.xy, high_xy_) + sums_of_products(p.yz, high_z_);
    return offset_ + (whole + (rest(p.xy, low_xy_) + rest(p.yz, low_z_)));
  }

 private:
  static constexpr std::int32_t high(std::int32_t value) {
    return static_cast<std::int32_t>((std::int64_t{value} + 0x8000) >> 16);
  }

  Words offset_;
  Halves high_xy_, high_z_, low_xy_, low_z_;
};

inline void store_pairs(void* at, Words first, Words second) {
  const __m128i a = as_sse2(first), b = as_sse2(second);
  auto* const to = static_cast<__m128i*>(at);
  _mm_storeu_si128(to, _mm_unpacklo_epi32(a, b));
  _mm_storeu_si128(to + 1, _mm_unpackhi_epi32(a, b));
}

}  // namespace zstrip::detail::vectors

#endif
