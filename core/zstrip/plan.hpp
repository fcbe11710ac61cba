// The planner: computes the bytes that a picture needs, by purpose, before anything is drawn. Quality presets by name.
// It is constexpr for baked scenes, so that firmware can size a static array with it.
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

/// Makes the plan. Further errors: view_size, samples, strip_rows and strip_columns for invalid shapes; effect_missing
/// for several samples without effect::supersampled; with a static layer store_range, samples and depth_effects for
/// pictures that StaticLayer::keep refuses.
constexpr PlanResult plan(const SceneCounts& counts, const View& view, Effects effects, const Budget& budget = {});

/// Estimates the cost of a frame with a plan, in instructions of a Cortex-M3. The estimate assumes that the scene fills
/// the view once with triangles of one size, of which half face away unless a material shows both sides. It serves to
/// compare plans; docs/memory.md has measurements.
constexpr std::uint64_t estimated_cost(const SceneCounts& counts, Effects effects, const View& view, const Plan& plan);

/// Estimates the cost of begin_frame and all strips of a frame that did this `work`. Fitted to the workloads of `zstrip
/// bench`, to the gallery and to scenes of single effects; nearly all are within 15 % (docs/performance.md,
/// "Estimates"). Edges, overlays and effect::csg are not included.
constexpr std::uint64_t estimated_cost(const SceneCounts& counts, Effects effects, const View& view, const Plan& plan,
                                       const Work& work);

/// The depth resolution that a picture needs; the counts of a scene do not contain it.
struct DepthNeed {
  DepthRange range;          ///< the range in which depth is stored
  Fixed farthest;            ///< distance of the last surfaces, 16.16, within `range`
  std::uint64_t separation;  ///< surfaces that are this far apart must be sorted; view units, 32.32
};

/// A plan and the effects that it is for: the requested ones, and the effect that selects the depth format.
struct PlanWithDepth {
  Status status;    ///< as in PlanResult
  Plan plan;        ///< as in PlanResult
  Effects effects;  ///< for the Renderer
};

/// Plans as `plan` above, but replaces any depth format in `effects` by cheapest_depth_format. Visibility methods and
/// sub-ranges always get z16. If even z24 cannot resolve `need`, the plan is for z24. The result can be constexpr, and
/// its effects the argument of a renderer:
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

// Presets: values to add to a scene's effects, budget and camera. docs/accuracy.md has the costs and benefits.

/// Used as Renderer<effects_of(scene, camera) | quality.effects> and plan(..., quality.budget).
struct Quality {
  std::string_view name;     ///< for find_quality
  Effects effects{};         ///< in addition to those that the scene needs
  Budget budget{};           ///< has the rows of a strip; set `bytes` and the other members for the board
  bool smooth = true;        ///< for Material::smooth of all materials: false is flat shading
  int detail_percent = 100;  ///< percentage of a mesh's triangles to keep when it is baked (meshoptimizer)
};

// Lower case, so that they read as values: quality::exact.
// NOLINTBEGIN(readability-identifier-naming)
/// The presets.
namespace quality {
/// Least memory: strips of 4 rows, half of the triangles, flat. For boards that cannot hold more.
inline constexpr Quality tiny{
    .name = "tiny", .budget = {.strip_rows = 4, .modes = Modes::streamed}, .smooth = false, .detail_percent = 50};
/// The renderer's defaults, in strips of 16 rows.
inline constexpr Quality balanced{.name = "balanced", .budget = {.strip_rows = 16, .modes = Modes::streamed}};
/// Highest accuracy: each pixel gets the exact texel. For scenes seen with perspective.
inline constexpr Quality exact{
    .name = "exact", .effects = effect::perspective_1, .budget = {.strip_rows = 16, .modes = Modes::streamed}};
/// All presets, from the least memory to the best picture.
inline constexpr const Quality* all[]{&tiny, &balanced, &exact};
}  // namespace quality
// NOLINTEND(readability-identifier-naming)

/// Returns the preset of this name, or null if there is none.
constexpr const Quality* find_quality(std::string_view name) {
  for (const Quality* preset : quality::all) {
    if (preset->name == name) return preset;
  }
  return nullptr;
}

}  // namespace zstrip

#include "zstrip/plan/planner.hpp"
