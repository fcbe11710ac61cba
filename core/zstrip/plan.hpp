// The planner: how many bytes a picture needs, for what, before anything is drawn. Quality presets by name. constexpr
// for baked scenes, so that firmware can size a static array with it.
#pragma once

#include <cstdint>
#include <string_view>

#include "zstrip/budget.hpp"
#include "zstrip/effects.hpp"
#include "zstrip/plan/depth_choice.hpp"
#include "zstrip/plan/scene_counts.hpp"
#include "zstrip/scene.hpp"

namespace zstrip {

struct Work;

/// Also Error::view_size, samples, strip_rows, strip_columns for shapes that cannot be, Error::effect_missing for
/// several samples without effect::supersampled; with a static layer Error::store_range, samples and depth_effects for
/// what StaticLayer::keep refuses.
constexpr PlanResult plan(const SceneCounts& counts, const View& view, Effects effects, const Budget& budget = {});

/// What a frame is thought to cost with a plan, in instructions of a Cortex-M3: a scene is assumed to fill the view
/// once with triangles of one size, half of them facing away if no material shows both sides. For comparing plans;
/// docs/memory.md has measurements.
constexpr std::uint64_t estimated_cost(const SceneCounts& counts, Effects effects, const View& view, const Plan& plan);

/// What begin_frame and all strips of a frame cost that did this `work`. Fitted to the workloads of `zstrip bench` in
/// strips of 8 to 480 rows, 97 % of which are within 15 % (docs/performance.md, "Estimates"); effects that none of them
/// has are not in it, but for samples.
constexpr std::uint64_t estimated_cost(const SceneCounts& counts, Effects effects, const View& view, const Plan& plan,
                                       const Work& work);

/// What a picture needs of its depth; not known from a scene's counts.
struct DepthNeed {
  DepthRange range;          ///< between which depth is kept
  Fixed farthest;            ///< where the last surfaces are, 16.16: in the range
  std::uint64_t separation;  ///< what lies this far behind something else is to be sorted; view units, 32.32
};

/// A plan and the effects that it is for: those requested, and what selects the depth format.
struct PlanWithDepth {
  Status status;    ///< as of PlanResult
  Plan plan;        ///< as of PlanResult
  Effects effects;  ///< for the Renderer
};

/// Plans as `plan` above does, with the format of cheapest_depth_format in place of any that `effects` has. Visibility
/// methods and sub-ranges always have z16. If not even z24 sorts what is needed, the plan is for z24. The result can be
/// constexpr, and its effects a renderer's:
///     constexpr PlanWithDepth kPlan = plan(kCounts, kView, kEffects, kBudget, {kRange, kFarthest, kSeparation});
/// and Renderer<kPlan.effects>.
constexpr PlanWithDepth plan(const SceneCounts& counts, const View& view, Effects effects, const Budget& budget,
                             const DepthNeed& need) {
  const Effects others = without(effects, effect::depth_formats);
  const auto planned = [&](DepthFormat format) -> PlanWithDepth {
    const Effects all = others | depth_effect(format);
    const PlanResult result = plan(counts, view, all, budget);
    return {result.status, result.plan, all};
  };
  if (others.methods != 0 || others.has(effect::depth_ranges)) return planned(DepthFormat::z16);
  return planned(cheapest_depth_format(need.range, need.farthest, need.separation));
}

// Presets: what to add to a scene's effects, to its budget and to its camera. docs/accuracy.md has what each costs and
// buys.

/// Renderer<effects_of(scene, camera) | quality.effects>, plan(..., quality.budget).
struct Quality {
  std::string_view name;     ///< for find_quality
  Effects effects{};         ///< beside those that the scene calls for
  Budget budget{};           ///< rows of a strip; set `bytes` and the rest as the board has it
  bool smooth = true;        ///< for Material::smooth of all materials: false is flat shading
  int detail_percent = 100;  ///< of the triangles of a mesh, how many to keep where it is baked (meshoptimizer)
};

// They read as values: quality::exact.
// NOLINTBEGIN(readability-identifier-naming)
/// The presets.
namespace quality {
/// Least memory: strips of 4 rows, half of the triangles, flat. For boards that cannot hold more.
inline constexpr Quality tiny{
    .name = "tiny", .budget = {.strip_rows = 4, .modes = Modes::streamed}, .smooth = false, .detail_percent = 50};
/// The renderer's defaults, in strips of 16 rows.
inline constexpr Quality balanced{.name = "balanced", .budget = {.strip_rows = 16, .modes = Modes::streamed}};
/// Closest to the truth: each pixel of a texture in its exact place. Meant for scenes seen with perspective.
inline constexpr Quality exact{
    .name = "exact", .effects = effect::perspective_1, .budget = {.strip_rows = 16, .modes = Modes::streamed}};
/// From the least memory to the best picture.
inline constexpr const Quality* all[]{&tiny, &balanced, &exact};
}  // namespace quality
// NOLINTEND(readability-identifier-naming)

/// The preset of this name; null if there is none.
constexpr const Quality* find_quality(std::string_view name) {
  for (const Quality* preset : quality::all) {
    if (preset->name == name) return preset;
  }
  return nullptr;
}

}  // namespace zstrip

#include "zstrip/plan/planner.hpp"
