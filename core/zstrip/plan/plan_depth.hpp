// The plan that also chooses how depth is kept, from how far apart surfaces lie.
#pragma once

#include <cstdint>

#include "zstrip/plan/depth_choice.hpp"
#include "zstrip/plan/plan.hpp"

namespace zstrip {

/// What a picture asks of its depth; no counts of a scene tell.
struct DepthNeed {
  DepthRange range;          ///< between which depth is kept
  Fixed farthest;            ///< where the last surfaces are, 16.16: in the range
  std::uint64_t separation;  ///< what lies this far behind something else is to be sorted; view units, 32.32
};

/// A plan and the effects that it is for: those that were asked for, and what selects the depth format.
struct PlanWithDepth {
  Status status;  ///< as of PlanResult
  Plan plan;
  Effects effects;
};

/// As `plan` above, with the format of cheapest_depth_format in place of any that `effects` has; or with w16, on most
/// scenes the slowest, where it sorts as well and four bytes a cell do not fit (or cannot be kept, with a static
/// layer). Visibility methods and sub-ranges always have z16. If not even z32 sorts what is needed, the plan is for
/// z32. constexpr, so that the effects can be a renderer's:
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
  const DepthFormat cheapest = cheapest_depth_format(need.range, need.farthest, need.separation);
  const PlanWithDepth best = planned(cheapest);
  if (best.status || depth_bytes(cheapest) == kDepthBytes) return best;
  if (depth_separation(DepthFormat::w16, need.range, need.farthest) > need.separation) return best;
  const PlanWithDepth narrow = planned(DepthFormat::w16);
  return narrow.status ? narrow : best;
}

}  // namespace zstrip
