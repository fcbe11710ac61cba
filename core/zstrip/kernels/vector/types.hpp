// Vectors of 16 bytes, eight halves or four words, both modulo their size; and functions of their operators.
#pragma once

#include <cstdint>

#include "zstrip/base/processor.hpp"

#if ZSTRIP_HAS_VECTORS

namespace zstrip::detail::vectors {

using Halves [[gnu::vector_size(16)]] = std::uint16_t;
using Words [[gnu::vector_size(16)]] = std::uint32_t;

template <class Vector>
Halves as_halves(Vector vector) {
  return __builtin_bit_cast(Halves, vector);
}
template <class Vector>
Words as_words(Vector vector) {
  return __builtin_bit_cast(Words, vector);
}

inline Halves in_all_halves(std::int32_t value) {
  const auto half = static_cast<std::uint16_t>(value);
  return Halves{half, half, half, half, half, half, half, half};
}
inline Words in_all_words(std::uint32_t value) { return Words{value, value, value, value}; }
inline Words load_words(const std::uint32_t* at) {
  Words words;
  __builtin_memcpy(&words, at, sizeof words);
  return words;
}
inline void store_words(std::uint32_t* at, Words words) { __builtin_memcpy(at, &words, sizeof words); }

inline std::uint32_t pair_of(std::int32_t low, std::int32_t high) {
  return (static_cast<std::uint32_t>(high) << 16) | (static_cast<std::uint32_t>(low) & 0xFFFF);
}
inline Halves in_all_pairs(std::int32_t low, std::int32_t high) { return as_halves(in_all_words(pair_of(low, high))); }

/// Keeps a value in a register from here on. Otherwise GCC mixes independent code and runs out of registers.
template <class Vector>
Vector settled(Vector vector) {
#if ZSTRIP_HAS_SSE2
  asm("" : "+x"(vector));
#else
  asm("" : "+w"(vector));
#endif
  return vector;
}

/// Shifts right and keeps the sign.
inline Halves arithmetically_right(Halves values, int by) {
  using Signed [[gnu::vector_size(16)]] = std::int16_t;
  return as_halves(__builtin_bit_cast(Signed, values) >> by);
}
inline Words arithmetically_right(Words values, int by) {
  using Signed [[gnu::vector_size(16)]] = std::int32_t;
  return as_words(__builtin_bit_cast(Signed, values) >> by);
}

inline Words greater(Words a, Words b) {
  using Signed [[gnu::vector_size(16)]] = std::int32_t;
  return as_words(__builtin_bit_cast(Signed, a) > __builtin_bit_cast(Signed, b));
}
inline Halves greater(Halves a, Halves b) {
  using Signed [[gnu::vector_size(16)]] = std::int16_t;
  return as_halves(__builtin_bit_cast(Signed, a) > __builtin_bit_cast(Signed, b));
}

/// Returns a value in the pixels of a block of four columns and two rows, from its steps a pixel.
inline Halves stepped_halves(Halves start, Halves step_x, Halves step_y) {
  return start + step_x * Halves{0, 1, 2, 3, 0, 1, 2, 3} + step_y * Halves{0, 0, 0, 0, 1, 1, 1, 1};
}

}  // namespace zstrip::detail::vectors

#endif
