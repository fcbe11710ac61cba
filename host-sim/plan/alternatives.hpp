// The memory that a scene takes for one picture: the best plan within a budget, and plans with more or less memory.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "plan/depth_advice.hpp"
#include "plan/kept_frames.hpp"
#include "plan/ram_limit.hpp"
#include "render/stage.hpp"
#include "result.hpp"
#include "zstrip/base/statistics.hpp"
#include "zstrip/plan.hpp"

namespace zstrip::sim {

/// One plan, and the statistics of the first frame drawn with it.
struct Alternative {
  Plan plan;
  std::uint64_t total_bytes = 0;   ///< arena, strip buffers and static layer
  std::uint64_t instructions = 0;  ///< of a Cortex-M3, estimated from `statistics`
  Statistics statistics;
  bool overflowed = false;  ///< its bins were too small for this frame, which was drawn in Mode::streamed
};

struct PlanRequest {
  View view;
  std::optional<bool> edges{};  ///< the argument of with_edges
  Budget budget;                ///< bytes, rows, columns, buffers and layer as given by the user
  RamLimit ram_limit = RamLimit::given;
  bool may_bin = true;  ///< false: only streamed plans
  DepthFormat depth_format = DepthFormat::z16;
  std::optional<DepthNeed> depth{};  ///< if set, the planner chooses the format
  Effects perspective{};             ///< one of effect::perspective_runs, for baked output; plans do not depend on it
  Effects method{};  ///< visibility method; empty: the z-buffer. The scene is prepared for it (PreparedScene).
};

struct PlanChoice {
  SceneCounts counts;
  Effects effects;  ///< of scene, picture and request
  Alternative chosen;
  DepthFormat depth_format = DepthFormat::z16;  ///< of all these plans
  std::vector<Alternative> curve;    ///< from the smallest plan to a single strip, each faster than the one before
  std::uint64_t flash_bytes = 0;     ///< of the scene, without the program; set by the caller
  std::uint64_t moved_bytes = 0;     ///< RAM of moved vertices, in addition to the plan; set by the caller
  std::uint64_t level_bytes = 0;     ///< RAM of instances that levels of detail change, likewise
  KeptFrames kept;                   ///< the memory of the scene as a static layer
  std::optional<DepthAdvice> depth;  ///< nothing if no surface is visible
};

/// Returns the request, with more bytes if the scene needs them and the limit is not given.
PlanRequest with_enough_ram(const Staging& staging, const PlanRequest& request);

/// Returns the plan of least estimated cost. Failures as in choose_plan.
Result<Plan> best_plan(const Staging& staging, const PlanRequest& request);

/// Chooses the plan, draws it, and adds alternatives. Failures: ExitStatus::budget with the bytes that are needed and
/// the smallest change that would fit.
Result<PlanChoice> choose_plan(const Staging& staging, const PlanRequest& request);

}  // namespace zstrip::sim
