// Plans for a range of budgets, each drawn once for its statistics.
#include "plan/alternatives.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "plan/staged_cost.hpp"
#include "render/render_frame.hpp"
#include "text/number.hpp"
#include "zstrip/effects.hpp"

namespace zstrip::sim {
namespace {

constexpr int kPointsOfCurve = 24;

class Planning {
 public:
  Planning(const Staging& staging, const PlanRequest& request)
      : staging_(staging),
        request_(request),
        counts_(count(staging.scene)),
        effects_(effects_of(staging.scene, staging.camera) | effects_of(request.view) |
                 depth_effect(request.depth_format) | request.method | (request.may_bin ? effect::bins : Effects{})) {
    if (request.depth) effects_ = zstrip::plan(counts_, request.view, effects_, request.budget, *request.depth).effects;
  }

  const SceneCounts& counts() const { return counts_; }
  Effects effects() const { return effects_; }
  DepthFormat depth_format() const { return zstrip::depth_format(effects_); }

  /// Plans with `budget`, and with the request's view and effects.
  PlanResult plan(const Budget& budget) const { return zstrip::plan(counts_, request_.view, effects_, budget); }

  std::uint64_t total_bytes(const Plan& plan) const {
    return std::uint64_t{plan.bytes()} +
           std::uint64_t{request_.budget.strip_buffers} * plan.strip_pixel_bytes(request_.view) +
           request_.budget.layer.sum();
  }

  Result<Alternative> draw(const Plan& plan) {
    FrameRenderer renderer(request_.view, {}, depth_effect(depth_format()));
    renderer.set_visibility(request_.method, {});
    const Result<FrameReport> report = renderer.render(staging_, plan);
    if (!report) return report.failure();
    const Statistics& done = report->statistics;
    Plan drawn = plan;
    drawn.mode = report->mode;
    return Alternative{.plan = plan,
                       .total_bytes = total_bytes(plan),
                       .instructions = staged_cost(staging_, counts_, effects_, request_.view, drawn, work_of(done)),
                       .statistics = done,
                       .overflowed = drawn.mode != plan.mode};
  }

 private:
  const Staging& staging_;
  const PlanRequest& request_;
  SceneCounts counts_;
  Effects effects_;
};

/// Returns the smallest change of the given options that makes a plan fit; tries one option after the other.
std::string cheapest_change(const Planning& planning, const Budget& given, const View& view) {
  Budget changed = given;
  std::string words;
  const auto fits_with = [&](const char* option) {
    if (!words.empty()) words += ' ';
    words += option;
    return static_cast<bool>(planning.plan(changed).status);
  };
  const auto would_fit = [&] { return fmt::format("{} would fit", words); };
  if (changed.modes == Modes::binned) {
    changed.modes = Modes::any;
    if (fits_with("--mode any")) return would_fit();
  }
  if (changed.strip_rows != 0) {
    changed.strip_rows = 0;
    if (fits_with("--strip-rows auto")) return would_fit();
  }
  if (changed.strip_columns != 0) {
    changed.strip_columns = 0;
    if (fits_with("--strip-columns auto")) return would_fit();
  }
  if (!changed.split_columns) {
    changed.split_columns = true;
    if (fits_with("--split-columns")) return would_fit();
  }
  if (changed.strip_buffers > 1) {
    changed.strip_buffers = 1;
    if (fits_with("--strip-buffers 1")) return would_fit();
  }
  changed.bytes = 1;
  const std::uint32_t least = planning.plan(changed).status.needed;
  return fmt::format("no plan for {}x{} fits; the smallest needs {}{}", view.width, view.height, counted(least, "byte"),
                     words.empty() ? "" : " (" + words + ")");
}

Result<Plan> best_plan(const Planning& planning, const PlanRequest& request) {
  const PlanResult best = planning.plan(request.budget);
  if (best.status.error == Error::arena_too_small) {
    return Failure{ExitStatus::budget,
                   fmt::format("needs {}, has {}, most of them for {}; {}", counted(best.status.needed, "byte"),
                               grouped(best.status.available), name(best.status.purpose),
                               cheapest_change(planning, request.budget, request.view))};
  }
  if (!best.status) {
    return Failure{ExitStatus::usage,
                   fmt::format("the picture cannot be planned: {}{}", message(best.status.error),
                               best.status.error == Error::unplannable ? "; ask for larger strips" : "")};
  }
  return best.plan;
}

}  // namespace

PlanRequest with_enough_ram(const Staging& staging, const PlanRequest& request) {
  const Planning planning(staging, request);
  PlanRequest enough = request;
  enough.budget =
      with_enough_ram(planning.counts(), request.view, planning.effects(), request.budget, request.ram_limit);
  return enough;
}

Result<Plan> best_plan(const Staging& staging, const PlanRequest& request) {
  return best_plan(Planning(staging, request), request);
}

Result<PlanChoice> choose_plan(const Staging& staging, const PlanRequest& request) {
  Planning planning(staging, request);
  const Result<Plan> best = best_plan(planning, request);
  if (!best) return best.failure();
  PlanChoice choice{.counts = planning.counts(),
                    .effects = planning.effects(),
                    .chosen = {},
                    .depth_format = planning.depth_format(),
                    .curve = {},
                    .kept = {},
                    .depth = {}};
  Result<Alternative> chosen = planning.draw(*best);
  if (!chosen) return chosen.failure();
  choice.chosen = *chosen;

  Budget budget = request.budget;
  budget.bytes = 1;
  const double smallest = planning.plan(budget).status.needed;
  budget.bytes = 0;
  const double largest = static_cast<double>(planning.total_bytes(planning.plan(budget).plan));
  for (int point = 0; point <= kPointsOfCurve; ++point) {
    // Even steps of the logarithm: each budget is larger by the same factor.
    budget.bytes = static_cast<std::uint32_t>(
        std::ceil(smallest * std::pow(std::max(1.0, largest / smallest), static_cast<double>(point) / kPointsOfCurve)));
    const PlanResult planned = planning.plan(budget);
    if (!planned.status) continue;
    Result<Alternative> drawn = planning.draw(planned.plan);
    if (!drawn) return drawn.failure();
    if (choice.curve.empty() || drawn->instructions < choice.curve.back().instructions) choice.curve.push_back(*drawn);
  }
  return choice;
}

}  // namespace zstrip::sim
