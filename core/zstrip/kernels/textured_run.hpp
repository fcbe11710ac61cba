// Kernel: draws runs of texels, the pixels of a span between two exact texture positions.
//
// Texture coordinates are 0.32 of the texture, so that they wrap; exact positions are 16.16 texels, modulo 2^16 texels;
// u/w and v/w have 29 bits and a sign, 1/w has 29 bits. Depth is the value that the rule steps, 16.16 codes with z16.
// Every implementation writes the same bits as portable/textured_run.hpp, and nothing outside the run. Assembly and
// vectors draw unlit texels, vectors and Thumb-2 also texels with flat light; only for the depth test of z16, without
// counting.
#pragma once

#include <cstdint>
#include <type_traits>

#include "zstrip/base/processor.hpp"
#include "zstrip/base/statistics.hpp"
#include "zstrip/kernels/mve/textured_run.hpp"
#include "zstrip/kernels/portable/textured_run.hpp"
#include "zstrip/kernels/thumb/textured_run.hpp"
#include "zstrip/kernels/vector/textured_run.hpp"
#include "zstrip/pixels/depth_rule.hpp"
#include "zstrip/pixels/plane.hpp"
#include "zstrip/pixels/textured_run_state.hpp"

namespace zstrip::detail {

/// True for the implementation that a TexturedRun with these arguments has, if it is not the portable one.
template <TexelLight lit, bool statistics, class Value, class Rule>
inline constexpr bool kHasThumbRuns =
    kHasThumb&& lit == TexelLight::none && !statistics && std::is_same_v<Rule, DepthRule<DepthMode{}>> &&
    std::is_same_v<Value, std::uint32_t>;
template <TexelLight lit, bool statistics, class Value, class Rule>
inline constexpr bool kHasThumbLitRuns =
    kHasThumb2&& lit == TexelLight::flat && !statistics && std::is_same_v<Rule, DepthRule<DepthMode{}>> &&
    std::is_same_v<Value, std::uint32_t>;
template <TexelLight lit, bool statistics, class Value, class Rule>
inline constexpr bool kHasVectorRuns =
    kHasVectors&& lit != TexelLight::smooth && !statistics && Rule::kNearerOnly && std::is_same_v<Value, std::uint32_t>;

/// True if fill_runs exists for these arguments.
template <TexelLight lit, bool statistics, class Value, class Rule>
inline constexpr bool kHasWholeRuns =
    kHasThumbRuns<lit, statistics, Value, Rule> || kHasVectorRuns<lit, statistics, Value, Rule>;

/// True if the implementation supports the run's texture; for fill_run and fill_runs.
template <TexelLight lit, bool statistics, class Value, class Rule, class State>
bool knows_texture([[maybe_unused]] const TexturedRun<lit, statistics, Value, Rule, State>& run) {
  if constexpr (kHasVectorRuns<lit, statistics, Value, Rule>) return fits_vector(run);
  return kHasWholeRuns<lit, statistics, Value, Rule>;
}

/// Fills `count` > 0 whole runs of kPerspectiveRun pixels, of a run for which knows_texture is true. Moves z, the place
/// and the exact position to their end.
template <TexelLight lit, bool statistics, class Value, class Rule>
void fill_runs(TexturedRun<lit, statistics, Value, Rule, TexturedRunsState>& run, std::uint16_t* depth,
               std::uint16_t* pixel, std::uint32_t count) {
  if constexpr (kHasThumbRuns<lit, statistics, Value, Rule>) {
    if constexpr (kHasMve) {
      if (fits_mve(run)) return fill_runs_mve(run, depth, pixel, count);
    }
    fill_runs_thumb(run, depth, pixel, count);
  } else if constexpr (lit == TexelLight::flat) {
    fill_lit_runs_vector(run, {run.r, run.g, run.b}, depth, pixel, count);
  } else {
    fill_runs_vector(run, depth, pixel, count);
  }
}

/// Fills `length` pixels, 1 .. 2^20. Moves z to the first pixel after the run. `known` is the result of knows_texture.
/// `light` is read only if the light is smooth.
template <TexelLight lit, bool statistics, class Value, class Rule, class State>
[[gnu::always_inline]] inline void fill_run(TexturedRun<lit, statistics, Value, Rule, State>& run,
                                            [[maybe_unused]] bool known, typename Rule::Cell* depth,
                                            std::uint16_t* pixel, std::int32_t length, const ColourPlanes& light,
                                            Statistics* counters) {
  if constexpr (kHasThumbRuns<lit, statistics, Value, Rule>) {
    if constexpr (kHasMve) {
      if (length >= kMinMveRun && fits_mve(run)) return fill_run_mve(run, depth, pixel, length);
    }
    fill_run_thumb(run, depth, pixel, length);
  } else if constexpr (kHasThumbLitRuns<lit, statistics, Value, Rule>) {
    fill_lit_run_thumb(run, depth, pixel, length);
  } else {
    if constexpr (kHasVectorRuns<lit, statistics, Value, Rule>) {
      if constexpr (lit == TexelLight::flat) {
        if (known) return fill_lit_run_vector(run, {run.r, run.g, run.b}, depth, pixel, length);
      } else {
        if (known) return fill_run_vector(run, depth, pixel, length);
      }
    }
    run.fill(depth, pixel, length, light, counters);
  }
}

}  // namespace zstrip::detail
