// Draws runs of texels, eight at a time, in assembly for Helium.
#pragma once

#include <cstdint>

#include "zstrip/base/processor.hpp"
#include "zstrip/pixels/textured_run_state.hpp"

namespace zstrip::detail {

/// True if the texture has at most 2^16 texels, so that a half can address each.
inline bool fits_mve(const WordRunState& run) { return run.to_row >= 16; }

/// Below this number of pixels the loop of Thumb-2 takes fewer instructions.
inline constexpr std::int32_t kMinMveRun = 5;

/// Fills `count` > 0 whole runs, with the depth test of z16. Moves z, the place and the exact position to their end.
void fill_runs_mve(TexturedRunsState& state, std::uint16_t* depth, std::uint16_t* pixel, std::uint32_t count);

/// Fills `length` pixels, 1 .. 2^20, with the depth test of z16. Moves `run.z` to the first pixel after the run.
void fill_run_mve(WordRunState& run, std::uint16_t* depth, std::uint16_t* pixel, std::int32_t length);

}  // namespace zstrip::detail
