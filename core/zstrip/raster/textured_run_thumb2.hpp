// Runs of texels without light in assembly for Thumb-2 (Cortex-M3, M4, M7): the same pixels as TexturedRun::fill and
// fill_textured, which a test on emulated cores compares.
#pragma once

#include <cstdint>

#include "zstrip/base/thumb2.hpp"

namespace zstrip::detail {

/// Where a run stands. The assembly reads the members in this order.
template <class Value>
struct TexturedRunState {
  std::uint32_t u, v, step_u, step_v;  ///< 0.32
  Value z, step_z;                     ///< a depth plane's
  const std::uint16_t* texels;
  std::int32_t to_column, to_row;  ///< right shifts; to_row leaves the row times the width of the texture
  std::uint32_t row_mask;          ///< clears the bits below a row
};

/// Where the whole runs of a span with perspective stand: 16 pixels between two exact positions.
struct TexturedRunsState : TexturedRunState<std::uint32_t> {
  std::uint32_t u_over_w, v_over_w, one_over_w;                 ///< at the first pixel of the next run
  std::uint32_t u_over_w_step, v_over_w_step, one_over_w_step;  ///< a run
  std::int32_t base_u, base_v;                                  ///< TextureCoordinates'
  std::int32_t from_u, from_v;                                  ///< the exact position there, 16.16
  std::uint32_t to_fraction_u, to_fraction_v;                   ///< TextureAxis'
  std::int32_t right_shift;  ///< after the division by w, for a 1/w that is normalised by 0
};

/// Fills `count` > 0 whole runs, with the depth test of z16. Moves z, the place and the exact position behind them.
void fill_runs_thumb2(TexturedRunsState& state, std::uint16_t* depth, std::uint16_t* pixel, std::uint32_t count);

/// `length` 1 .. 2^20, with the depth test of z16. Moves `run.z` to the first pixel behind the run.
void fill_run_thumb2(TexturedRunState<std::uint32_t>& run, std::uint16_t* depth, std::uint16_t* pixel,
                     std::int32_t length);

}  // namespace zstrip::detail
