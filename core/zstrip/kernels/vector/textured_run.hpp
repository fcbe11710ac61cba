// Draws runs of texels in vectors, unlit and with flat light.
#pragma once

#include <cstdint>

#include "zstrip/base/processor.hpp"
#include "zstrip/pixels/textured_run_state.hpp"

namespace zstrip::detail {

/// The factors of texels: the light_factor of each channel.
struct OneLight {
  std::uint32_t r, g, b;
};

/// True if the texture has at most 2^16 texels, so that the index of a vector's lane can address each.
inline bool fits_vector(const WordRunState& run) { return run.to_row >= 16; }

/// Fills `count` > 0 whole runs, with the depth test of z16. Moves z, the place and the exact position to their end.
void fill_runs_vector(TexturedRunsState& state, std::uint16_t* depth, std::uint16_t* pixel, std::uint32_t count);
/// Fills runs with texels multiplied by `light`.
void fill_lit_runs_vector(TexturedRunsState& state, const OneLight& light, std::uint16_t* depth, std::uint16_t* pixel,
                          std::uint32_t count);

/// Fills a run of `length` > 0 pixels, with the depth test of z16. Moves `run.z` to the first pixel after the run.
void fill_run_vector(WordRunState& run, std::uint16_t* depth, std::uint16_t* pixel, std::int32_t length);

/// Fills a run with texels multiplied by `light`.
void fill_lit_run_vector(WordRunState& run, const OneLight& light, std::uint16_t* depth, std::uint16_t* pixel,
                         std::int32_t length);

}  // namespace zstrip::detail
