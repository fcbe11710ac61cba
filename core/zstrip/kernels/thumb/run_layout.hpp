// The layout of the states of runs of texels, for assembly.
#pragma once

#include "zstrip/base/processor.hpp"
#include "zstrip/kernels/thumb/layout.hpp"
#include "zstrip/kernels/thumb/records.hpp"
#include "zstrip/pixels/textured_run_state.hpp"

// clang-format off
#define ZSTRIP_TEXEL_RUN(field, number)             \
  field(run, WordRunState, u, 0)                    \
  field(run, WordRunState, v, 4)                    \
  field(run, WordRunState, step_u, 8)               \
  field(run, WordRunState, step_v, 12)              \
  field(run, WordRunState, z, 16)                   \
  field(run, WordRunState, step_z, 20)              \
  field(run, WordRunState, texels, 24)              \
  field(run, WordRunState, to_column, 28)           \
  field(run, WordRunState, to_row, 32)              \
  field(run, WordRunState, row_mask, 36)            \
  field(lit, LitWordRunState, r, 40)                \
  field(lit, LitWordRunState, g, 44)                \
  field(lit, LitWordRunState, b, 48)                \
  field(runs, TexturedRunsState, u_over_w, 40)      \
  field(runs, TexturedRunsState, v_over_w, 44)      \
  field(runs, TexturedRunsState, one_over_w, 48)    \
  field(runs, TexturedRunsState, u_over_w_step, 52) \
  field(runs, TexturedRunsState, one_over_w_step, 60) \
  field(runs, TexturedRunsState, base_u, 64)        \
  field(runs, TexturedRunsState, base_v, 68)        \
  field(runs, TexturedRunsState, from_u, 72)        \
  field(runs, TexturedRunsState, from_v, 76)        \
  field(runs, TexturedRunsState, to_fraction_u, 80) \
  field(runs, TexturedRunsState, to_fraction_v, 84) \
  field(runs, TexturedRunsState, right_shift, 88)
// clang-format on

namespace zstrip::detail {

#if ZSTRIP_HAS_THUMB1 || ZSTRIP_HAS_THUMB2

// GCC and Clang place the members of a class without virtual bases as offsetof needs it.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Winvalid-offsetof"
ZSTRIP_CHECK_LAYOUT(ZSTRIP_TEXEL_RUN)
#pragma GCC diagnostic pop

#endif

}  // namespace zstrip::detail
