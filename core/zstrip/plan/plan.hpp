// How many bytes a picture needs, for what, before anything is drawn. constexpr for baked scenes, so that
// firmware can size a static array with it.
#pragma once

#include "zstrip/plan/plan_types.hpp"
#include "zstrip/plan/scene_counts.hpp"
#include "zstrip/scene/effects.hpp"
#include "zstrip/scene/scene.hpp"

namespace zstrip {

/// Also Error::view_size, samples, strip_rows, strip_columns for shapes that cannot be, Error::effect_missing for
/// several samples without effect::supersampled; with a static layer Error::store_range, samples and depth_effects for
/// what StaticLayer::keep refuses.
constexpr PlanResult plan(const SceneCounts& counts, const View& view, Effects effects, const Budget& budget = {});

/// What a frame is thought to cost with a plan, in instructions of a Cortex-M3: a scene is assumed to fill the view
/// once with triangles of one size, half of them facing away. For comparing plans; docs/memory.md has measurements.
constexpr std::uint64_t estimated_cost(const SceneCounts& counts, const View& view, const Plan& plan);

}  // namespace zstrip

#include "zstrip/plan/planner.hpp"
