// Draws runs of texels, in assembly for Cortex-M.
#pragma once

#include <cstdint>

#include "zstrip/base/processor.hpp"
#include "zstrip/pixels/textured_run_state.hpp"

namespace zstrip::detail {

/// Fills `count` > 0 whole runs, with the depth test of z16. Moves z, the place and the exact position to their end.
void fill_runs_thumb(TexturedRunsState& state, std::uint16_t* depth, std::uint16_t* pixel, std::uint32_t count);

/// Fills `length` pixels, 1 .. 2^20, with the depth test of z16. Moves `run.z` to the first pixel after the run.
void fill_run_thumb(WordRunState& run, std::uint16_t* depth, std::uint16_t* pixel, std::int32_t length);

/// Fills a run with texels multiplied by one colour. For Thumb-2.
void fill_lit_run_thumb(LitWordRunState& run, std::uint16_t* depth, std::uint16_t* pixel, std::int32_t length);

}  // namespace zstrip::detail
