// Bakes the scene, opens the blob as `zstrip render` does, and plans it as `zstrip bake` does.
#include "bench/scene_case.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <utility>

#include "cli/parse.hpp"
#include "cli/plan_arguments.hpp"
#include "plan/alternatives.hpp"
#include "render/stage.hpp"

namespace zstrip::sim {

Result<SceneCase> scene_case(const BakeArguments& bake, const BoardModel& board, std::uint32_t cores,
                             std::uint32_t frames) {
  SceneCase made;
  std::string blob = bake.scene;
  PlanArguments plan = bake.plan;
  if (!plan.memory.ram) plan.memory.ram = std::to_string((board.ram_bytes - kReservedRam) / cores);
  plan.strip_buffers = board.dma ? 2 : 1;
  if (kind_of_scene(bake.scene) != SceneKind::baked) {
    made.baked = std::make_unique<TemporaryFile>("zstrip_bench", ".zsc");
    blob = made.baked->path().string();
    BakeArguments arguments = bake;
    arguments.output = blob;
    arguments.plan = plan;
    arguments.quiet = true;
    if (const Result<Done> done = sim::bake(arguments); !done) return done.failure();
  }
  plan.view = {};  // the blob's
  const Result<PlanRequest> request = parse_plan(plan, blob);
  if (!request) return request.failure();
  const Result<std::unique_ptr<Stage>> stage = open_stage(blob, {}, {}, request->view, frames);
  if (!stage) return stage.failure();
  const Result<Staging> staging = (*stage)->place(0, frames);
  if (!staging) return staging.failure();
  if (!staging->tree.nodes.empty() || request->method != Effects{}) {
    return usage(
        fmt::format("'{}' was baked for a visibility method; boards count scenes with the z-buffer", bake.scene));
  }
  const Result<Plan> best = best_plan(*staging, *request);
  if (!best) return Failure{best.failure().status, fmt::format("'{}' {}", bake.scene, best.failure().message)};
  Effects effects = effects_of(staging->scene, staging->camera) | effects_of(request->view) | (*stage)->blob()->effects;
  const bool binned = best->mode == Mode::binned;
  if (binned) effects = effects | effect::bins;
  made.bench_case = {.workload = std::filesystem::path(bake.scene).filename().string(),
                     .target = std::string(board.target),
                     .view = request->view,
                     .budget = request->budget,
                     .frames = frames,
                     .program = fmt::format("zstrip_played_{}_{:014x}", board.target, effects.bits),
                     .scene_file = blob};
  made.bench_case.budget.modes = binned ? Modes::binned : Modes::streamed;
  made.bench_case.budget.strip_rows = best->strip_rows;
  made.bench_case.budget.strip_columns = best->strip_columns;
  return made;
}

}  // namespace zstrip::sim
