// The pixels of a run of texels, without light, in assembly for Thumb-2 (Cortex-M3, M4, M7): the same pixels as
// TexturedRun::fill, which a test on emulated cores compares.
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

/// `length` 1 .. 2^20, with the depth test of z16. Moves `run.z` to the first pixel behind the run.
void fill_run_thumb2(TexturedRunState<std::uint32_t>& run, std::uint16_t* depth, std::uint16_t* pixel,
                     std::int32_t length);

}  // namespace zstrip::detail
