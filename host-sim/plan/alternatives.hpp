// What a scene takes for one picture: the best plan for the memory that is allowed, and what more or less would buy.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "plan/depth_advice.hpp"
#include "plan/kept_frames.hpp"
#include "render/stage.hpp"
#include "result.hpp"
#include "zstrip/base/statistics.hpp"
#include "zstrip/plan.hpp"

namespace zstrip::sim {

/// One plan, and what drawing the first frame with it did.
struct Alternative {
  Plan plan;
  std::uint64_t total_bytes = 0;   ///< arena, strip buffers and static layer
  std::uint64_t instructions = 0;  ///< of a Cortex-M3, estimated from `statistics`
  Statistics statistics;
  bool overflowed = false;  ///< its bins were too small for this frame, which was streamed
};

struct PlanRequest {
  View view;
  std::optional<bool> edges{};  ///< what with_edges was told
  Budget budget;                ///< bytes, rows, columns, buffers and layer as given
  bool may_bin = true;          ///< else only streamed plans
  DepthFormat depth_format = DepthFormat::z16;
  std::optional<DepthNeed> depth{};  ///< then the planner chooses the format
  Effects perspective{};             ///< one of effect::perspective_runs, for what is baked; plans are the same
  Effects method{};  ///< how visibility is found; nothing: the z-buffer. The scene is prepared for it (PreparedScene).
};

struct PlanChoice {
  SceneCounts counts;
  Effects effects;  ///< of scene, picture and request
  Alternative chosen;
  DepthFormat depth_format = DepthFormat::z16;  ///< of all its plans
  std::vector<Alternative> curve;    ///< from the smallest plan to a single strip, each faster than the one before
  KeptFrames kept;                   ///< the scene as a static layer
  std::optional<DepthAdvice> depth;  ///< none if nothing is visible
};

/// The plan of least estimated cost. Failures as of choose_plan.
Result<Plan> best_plan(const Staging& staging, const PlanRequest& request);

/// The same, drawn, with alternatives. Failures: ExitStatus::budget with the bytes that are needed and the cheapest
/// change that would fit.
Result<PlanChoice> choose_plan(const Staging& staging, const PlanRequest& request);

}  // namespace zstrip::sim
