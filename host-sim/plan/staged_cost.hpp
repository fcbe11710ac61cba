// The estimated instructions of a frame: of drawing it, and of bending its skins before.
#pragma once

#include <cstdint>

#include "render/stage.hpp"
#include "zstrip/plan/estimate.hpp"

namespace zstrip::sim {

/// Returns the instructions on a Cortex-M3, compiled for speed. `counts`: those of staging.scene. skin_mesh() takes
/// some 400 a vertex, as the gallery's fox shows; a skin that is moved while it is drawn is part of estimated_cost().
inline std::uint64_t staged_cost(const Staging& staging, const SceneCounts& counts, Effects effects, const View& view,
                                 const Plan& plan, const Work& work) {
  constexpr std::uint64_t kBentVertex = 400;
  return estimated_cost(counts, effects, view, plan, work) + kBentVertex * staging.bent_vertices;
}

}  // namespace zstrip::sim
