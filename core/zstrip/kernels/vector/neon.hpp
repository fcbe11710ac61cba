// The functions of NEON that kernels in vectors need in addition to operators; sse2.hpp describes them.
#pragma once

#include <cstdint>

#include "zstrip/geometry/instance.hpp"
#include "zstrip/kernels/vector/types.hpp"
#include "zstrip/scene.hpp"

#if ZSTRIP_HAS_NEON

#include <arm_neon.h>

namespace zstrip::detail::vectors {

template <class Vector>
int16x8_t as_s16(Vector vector) {
  return __builtin_bit_cast(int16x8_t, vector);
}
template <class Vector>
uint16x8_t as_u16(Vector vector) {
  return __builtin_bit_cast(uint16x8_t, vector);
}
template <class Vector>
int32x4_t as_s32(Vector vector) {
  return __builtin_bit_cast(int32x4_t, vector);
}
template <class Vector>
uint32x4_t as_u32(Vector vector) {
  return __builtin_bit_cast(uint32x4_t, vector);
}

inline Halves load_8(const std::uint16_t* at) { return as_halves(vld1q_u16(at)); }
inline void store_8(std::uint16_t* at, Halves values) { vst1q_u16(at, as_u16(values)); }
inline Halves load_4(const std::uint16_t* at) { return as_halves(vcombine_u16(vld1_u16(at), vdup_n_u16(0))); }
inline void store_4(std::uint16_t* at, Halves values) { vst1_u16(at, vget_low_u16(as_u16(values))); }
inline Halves load_4_and_4(const std::uint16_t* at, const std::uint16_t* upper_at) {
  return as_halves(vcombine_u16(vld1_u16(at), vld1_u16(upper_at)));
}
inline void store_upper_4(std::uint16_t* at, Halves values) { vst1_u16(at, vget_high_u16(as_u16(values))); }

inline Words in_first_word(std::uint32_t value) { return as_words(vcombine_u32(vcreate_u32(value), vdup_n_u32(0))); }
inline Halves bytes_of(std::uint32_t word) { return as_halves(vmovl_u8(vcreate_u8(word))); }

template <int word>
Words word_in_all(Words values) {
  const uint32x4_t v = as_u32(values);
  if constexpr (word < 2) return as_words(vdupq_lane_u32(vget_low_u32(v), word));
  return as_words(vdupq_lane_u32(vget_high_u32(v), word & 1));
}
template <int half>
Halves half_in_all(Halves values) {
  const uint16x8_t v = as_u16(values);
  if constexpr (half < 4) return as_halves(vdupq_lane_u16(vget_low_u16(v), half & 3));
  return as_halves(vdupq_lane_u16(vget_high_u16(v), half & 3));
}
template <int half, int shift>
Halves half_in_all(Halves values) {
  return half_in_all<half>(values << shift);
}
template <int word, int shift>
Halves low_half_in_all(Halves values) {
  return half_in_all<2 * word, shift>(values);
}
template <int word, int shift>
Halves high_half_in_all(Halves values) {
  return half_in_all<2 * word + 1, shift>(values);
}
inline Words first_words(Words a, Words b, Words c) {
  const uint32x2_t a_b = vzip_u32(vget_low_u32(as_u32(a)), vget_low_u32(as_u32(b))).val[0];
  return as_words(vcombine_u32(a_b, vdup_lane_u32(vget_low_u32(as_u32(c)), 0)));
}
inline Words rotated(Words three) { return as_words(vextq_u32(as_u32(three), as_u32(three), 3)); }
inline Halves swapped_in_pairs(Halves values) { return as_halves(vrev32q_u16(as_u16(values))); }
inline Halves upper_halves(Words first_four, Words last_four) {
#if defined(__aarch64__)
  return as_halves(vuzp2q_u16(as_u16(first_four), as_u16(last_four)));
#else
  return as_halves(vcombine_u16(vshrn_n_u32(as_u32(first_four), 16), vshrn_n_u32(as_u32(last_four), 16)));
#endif
}

inline Halves lower_halves(Words first_four, Words last_four) {
  return as_halves(vcombine_u16(vmovn_u32(as_u32(first_four)), vmovn_u32(as_u32(last_four))));
}
inline Halves narrowed(Words first_four, Words last_four) { return lower_halves(first_four, last_four); }
template <class Vector>
Words even_words(Vector first, Vector last) {
  return as_words(vuzpq_u32(as_u32(first), as_u32(last)).val[0]);
}
template <class Vector>
Words odd_words(Vector first, Vector last) {
  return as_words(vuzpq_u32(as_u32(first), as_u32(last)).val[1]);
}
inline Halves lower_pairs(Halves low, Halves high) { return as_halves(vtrnq_u16(as_u16(low), as_u16(high)).val[0]); }
inline Halves upper_pairs(Halves low, Halves high) { return as_halves(vtrnq_u16(as_u16(low), as_u16(high)).val[1]); }
inline Halves interleaved_low(Halves a, Halves b) { return as_halves(vzipq_u16(as_u16(a), as_u16(b)).val[0]); }
inline Halves interleaved_high(Halves a, Halves b) { return as_halves(vzipq_u16(as_u16(a), as_u16(b)).val[1]); }

inline Words multiples_0_to_3(Words step) { return step * Words{0, 1, 2, 3}; }
inline Halves unsigned_max(Halves a, Halves b) { return as_halves(vmaxq_u16(as_u16(a), as_u16(b))); }
inline Halves rgb565_of_halves(Halves r, Halves g, Halves b) {
  return as_halves(vsriq_n_u16(vsriq_n_u16(as_u16(r), as_u16(g), 5), as_u16(b), 11));
}
inline Halves signed_min(Halves a, Halves b) { return as_halves(vminq_s16(as_s16(a), as_s16(b))); }
inline Halves signed_max(Halves a, Halves b) { return as_halves(vmaxq_s16(as_s16(a), as_s16(b))); }
inline Halves chosen(Halves mask, Halves a, Halves b) {
  return as_halves(vbslq_u16(as_u16(mask), as_u16(a), as_u16(b)));
}
/// Tests one byte of each half, in a long word.
inline bool any_clear(Halves mask) {
  const uint8x8_t bytes = vmovn_u16(as_u16(mask));
  return vget_lane_u64(vreinterpret_u64_u8(bytes), 0) != ~std::uint64_t{0};
}
inline bool any_set(Halves values) { return any_clear(as_halves(values == Halves{})); }

inline Words sums_of_products(Halves a, Halves b) {
  const int32x4_t low = vmull_s16(vget_low_s16(as_s16(a)), vget_low_s16(as_s16(b)));
  const int32x4_t high = vmull_s16(vget_high_s16(as_s16(a)), vget_high_s16(as_s16(b)));
#if defined(__aarch64__)
  return as_words(vpaddq_s32(low, high));
#else
  return as_words(vcombine_s32(vpadd_s32(vget_low_s32(low), vget_high_s32(low)),
                               vpadd_s32(vget_low_s32(high), vget_high_s32(high))));
#endif
}
inline std::int32_t sum_of_products(Halves a, Halves b) {
  const int32x2_t both = vget_low_s32(vmull_s16(vget_low_s16(as_s16(a)), vget_low_s16(as_s16(b))));
  return vget_lane_s32(vpadd_s32(both, both), 0);
}
inline Words lower_then_upper(Halves pairs) {
  return as_words(vsraq_n_s32(vshlq_n_s32(as_s32(pairs), 16), as_s32(pairs), 16));
}
inline Halves upper_products_of_halves(Halves a, Halves b) {
  return upper_halves(as_words(vmull_u16(vget_low_u16(as_u16(a)), vget_low_u16(as_u16(b)))),
                      as_words(vmull_u16(vget_high_u16(as_u16(a)), vget_high_u16(as_u16(b)))));
}
inline Words times_half(Words words, Halves factors) { return words * (as_words(factors) >> 16); }
inline std::uint32_t sum(Words words) {
#if defined(__aarch64__)
  return vaddvq_u32(as_u32(words));
#else
  const uint32x2_t pairs = vadd_u32(vget_low_u32(as_u32(words)), vget_high_u32(as_u32(words)));
  return vget_lane_u32(vpadd_u32(pairs, pairs), 0);
#endif
}
template <int shift>
Words upper_products(Words a, Words b) {
  // The instruction doubles the product.
  if constexpr (shift == 0) return as_words(vshrq_n_s32(vqdmulhq_s32(as_s32(a), as_s32(b)), 1));
  return as_words(vqdmulhq_s32(as_s32(a << (shift - 1)), as_s32(b)));
}

inline Words products_of_even(Words a, Words b) { return a * b; }
inline Words upper_products_of_even(Words a, Words b) { return upper_products<0>(a, b); }

class HalvesOfProducts {
 public:
  explicit HalvesOfProducts(Words factors) : factors_(factors) {}
  Halves of(Words values) const {
    const Words products = upper_products<9>(values, factors_);
    return lower_halves(products, products);
  }

 private:
  Words factors_;
};

template <int shift>
Words rounded_upper_products(Words a, Words b) {
  return as_words(vqrdmulhq_s32(as_s32(a << (shift - 1)), as_s32(b)));
}
inline std::uint32_t upper_bits(Words words) { return sum((words >> 31) << Words{0, 1, 2, 3}); }

class WordFactors {
 public:
  WordFactors(Words first, Words second) : first_(first), second_(second) {}
  Words sums(Halves pairs) const {
    const Words words = as_words(pairs);
    return first_ * arithmetically_right(words << 16, 16) + second_ * arithmetically_right(words, 16);
  }

 private:
  Words first_, second_;
};

template <int edge>
Halves stepped_edge(Words starts, Halves steps) {
  return stepped_halves(half_in_all<2 * edge>(as_halves(starts)), half_in_all<2 * edge>(steps),
                        half_in_all<2 * edge + 1>(steps));
}

class Weights {
 public:
  Weights(Halves edge_steps, Words at_anchor) {
    const int32x4_t steps = vshll_n_s16(vget_low_s16(as_s16(edge_steps)), 4);
    const int32x4_t starts = as_s32(at_anchor);
    of_1_ = as_words(vcombine_s32(vget_low_s32(steps), vget_low_s32(starts)));
    of_2_ = as_words(vextq_s32(steps, vextq_s32(starts, starts, 1), 2));
  }
  Words sum(std::uint32_t of_1, std::uint32_t of_2) const {
    return as_words(vmlaq_n_u32(vmulq_n_u32(as_u32(of_1_), of_1), as_u32(of_2_), of_2));
  }

  struct Factors {
    int32x4_t of_1, of_2;
    Factors(Halves first, Halves second)
        : of_1(vmovl_s16(vget_low_s16(as_s16(first)))), of_2(vmovl_s16(vget_low_s16(as_s16(second)))) {}
  };
  template <int half>
  Words sum(const Factors& factors) const {
    return of_1_ * word_in_all<half>(as_words(factors.of_1)) + of_2_ * word_in_all<half>(as_words(factors.of_2));
  }

 private:
  Words of_1_, of_2_;
};

inline Words unsigned_upper_products(Words a, Words b) {
  const uint32x4_t low = vreinterpretq_u32_u64(vmull_u32(vget_low_u32(as_u32(a)), vget_low_u32(as_u32(b))));
  const uint32x4_t high = vreinterpretq_u32_u64(vmull_u32(vget_high_u32(as_u32(a)), vget_high_u32(as_u32(b))));
  return as_words(vuzpq_u32(low, high).val[1]);
}

class FourShifts {
 public:
  static std::uint32_t of(int number) { return static_cast<std::uint32_t>(number); }

  explicit FourShifts(Words numbers) : left_(as_s32(numbers)) {}
  Words arithmetically(Words values, int amount) const { return as_words(vshlq_s32(as_s32(values), left(amount))); }
  Words logically(Words values, int amount) const { return as_words(vshlq_u32(as_u32(values), left(amount))); }

 private:
  int32x4_t left(int amount) const { return vsubq_s32(left_, vdupq_n_s32(amount)); }

  int32x4_t left_;
};

struct FourPositions {
  int32x4_t x, y, z;  ///< times 2^15

  explicit FourPositions(const Position* p) {
    const int16x4x3_t positions = vld3_s16(&p->x);
    x = vshll_n_s16(positions.val[0], 15), y = vshll_n_s16(positions.val[1], 15);
    z = vshll_n_s16(positions.val[2], 15);
  }
};

/// The instruction doubles products: floor(a p / 2^16) is the upper word of 2 a 2^15 p.
class FormOfFour {
 public:
  explicit FormOfFour(const LinearForm& f) : form_(f) {}

  Words at(const FourPositions& p) const {
    const int32x4_t xy = vaddq_s32(vqdmulhq_n_s32(p.x, form_.x), vqdmulhq_n_s32(p.y, form_.y));
    return as_words(vaddq_s32(vaddq_s32(vdupq_n_s32(form_.offset), xy), vqdmulhq_n_s32(p.z, form_.z)));
  }

 private:
  LinearForm form_;
};

inline void store_pairs(void* at, Words first, Words second) {
  vst2q_u32(static_cast<std::uint32_t*>(at), uint32x4x2_t{{as_u32(first), as_u32(second)}});
}

}  // namespace zstrip::detail::vectors

#endif
