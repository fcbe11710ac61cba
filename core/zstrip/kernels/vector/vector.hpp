// The language of the kernels in vectors: two types, their operators, and functions of the instruction set.
#pragma once

#include "zstrip/kernels/vector/neon.hpp"
#include "zstrip/kernels/vector/sse2.hpp"
#include "zstrip/kernels/vector/types.hpp"

#if ZSTRIP_HAS_VECTORS

#include <cstdint>

namespace zstrip::detail::vectors {

/// Returns start, start + step, start + 2 step, start + 3 step.
inline Words stepped_words(std::uint32_t start, std::uint32_t step) {
  return in_all_words(start) + multiples_0_to_3(in_all_words(step));
}

}  // namespace zstrip::detail::vectors

#endif
