// Where the assembly for runs of texels, in Thumb-1 and Thumb-2, expects what C++ hands to it.
#pragma once

#include <cstddef>

#include "zstrip/kernels/processor.hpp"
#include "zstrip/kernels/textured_run_state.hpp"

namespace zstrip::detail {

#if ZSTRIP_HAS_THUMB1 || ZSTRIP_HAS_THUMB2

static_assert(offsetof(WordRunState, z) == 16 && offsetof(WordRunState, step_z) == 20 &&
              offsetof(WordRunState, texels) == 24 && offsetof(WordRunState, to_column) == 28 &&
              offsetof(WordRunState, to_row) == 32 && offsetof(WordRunState, row_mask) == 36);
// No gaps: the members lie in order.
static_assert(sizeof(WordRunState) == 40 && sizeof(LitWordRunState) == 52 && sizeof(TexturedRunsState) == 92);

#endif

}  // namespace zstrip::detail
