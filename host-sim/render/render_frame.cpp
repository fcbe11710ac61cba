// Draws one frame of a scene into pixels: effects, plan, begin, strips.
#include "render/render_frame.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <chrono>

#include "render/display_pair.hpp"
#include "render/frame_refused.hpp"
#include "render/parallel.hpp"
#include "text/number.hpp"
#include "visibility/methods.hpp"
#include "visibility/prepared_scene.hpp"
#include "zstrip/fingerprints.hpp"
#include "zstrip/renderer.hpp"
#include "zstrip_hal/present.hpp"

namespace zstrip::sim {
namespace {

static_assert(kArenaAlignment <= alignof(std::uint64_t));

/// Returns at least `bytes` of `words`, whose contents do not matter.
std::span<std::byte> at_least(std::vector<std::uint64_t>& words, std::uint32_t bytes) {
  const std::size_t needed = (std::size_t{bytes} + sizeof(std::uint64_t) - 1) / sizeof(std::uint64_t);
  if (words.size() < needed) words.resize(needed);
  return std::as_writable_bytes(std::span(words)).first(bytes);
}

Failure too_little_memory(const Status& status, const Scene& scene, const View& view, Effects effects,
                          const Budget& budget, bool other_rows_would_do) {
  const SceneCounts counts = count(scene);
  const std::uint16_t rows = other_rows_would_do ? std::uint16_t{0} : budget.strip_rows;
  const std::uint32_t smallest = plan(counts, view, effects,
                                      {.bytes = 1,
                                       .strip_rows = rows,
                                       .strip_columns = budget.strip_columns,
                                       .strip_buffers = budget.strip_buffers})
                                     .status.needed;
  std::string advice = fmt::format("--ram {} is the smallest that works", smallest);
  if (budget.strip_rows != rows && smallest <= budget.bytes)
    advice = "try --strip-rows auto";
  else if (budget.strip_rows != rows)
    advice += " (with --strip-rows auto)";
  const bool whole_meshes =
      std::any_of(scene.meshes.begin(), scene.meshes.end(), [](const Mesh& mesh) { return mesh.meshlets.empty(); });
  if (status.purpose == Purpose::vertices && whole_meshes) {
    advice += "; meshes cut into meshlets, as in knot_meshlets and all model files, need far less for vertices";
  }
  return {ExitStatus::budget,
          fmt::format("RAM of {} is too little: {} needed, most of them for {}, {} missing; {}",
                      counted(budget.bytes, "byte"), counted(status.needed, "byte"), name(status.purpose),
                      counted(status.needed - status.available, "byte"), advice)};
}

/// Counts the strips that a panel does not know yet.
struct CountedFrame : FingerprintedFrame<AnyRenderer, SimulatedPanel::kStrips> {
  using FingerprintedFrame::FingerprintedFrame;
  std::uint32_t drawn = 0;
  Status draw_strip(std::uint16_t strip, std::span<std::byte> pixels) {
    ++drawn;
    return FingerprintedFrame::draw_strip(strip, pixels);
  }
};

/// Adds the statistics of a thread since begin_frame.
void add(Statistics& sum, const Statistics& all, const Statistics& after_begin) {
  sum.drawn += all.drawn - after_begin.drawn;
  sum.clipped += all.clipped - after_begin.clipped;
  sum.covering += all.covering - after_begin.covering;
  sum.vertices += all.vertices - after_begin.vertices;
  sum.fragments += all.fragments - after_begin.fragments;
  sum.depth_passes += all.depth_passes - after_begin.depth_passes;
  for (std::size_t kind = 0; kind < kWorkKinds; ++kind)
    sum.work.of[kind] += all.work.of[kind] - after_begin.work.of[kind];
}

}  // namespace

std::uint32_t checksum(std::span<const std::byte> pixels) {
  return static_cast<std::uint32_t>(
      crc32_z(crc32_z(0, nullptr, 0), reinterpret_cast<const Bytef*>(pixels.data()), pixels.size()));
}

/// Plans within the budget, which gets the bytes and rows that are needed.
PlanResult FrameRenderer::plan_within(Budget& budget, const SceneCounts& counts, Effects effects) const {
  const auto plan_with = [&](std::uint16_t rows) {
    budget.strip_rows = rows;
    budget = with_enough_ram(counts, view_, effects, budget, ram_limit_);
    return plan(counts, view_, effects, budget);
  };
  const PlanResult planned = plan_with(budget.strip_rows);
  const int rows = planned.plan.strip_rows / row_step_ * row_step_;
  if (planned.status && rows == planned.plan.strip_rows) return planned;
  if (row_step_ == 1 || budget.strip_rows != 0) return planned;
  return plan_with(static_cast<std::uint16_t>(std::min<int>(std::max<int>(rows, row_step_), view_.height)));
}

Result<FrameReport> FrameRenderer::render(const Staging& original) {
  const Result<PreparedScene> prepared = PreparedScene::of(original, method_);
  if (!prepared) return prepared.failure();
  const Staging staging = prepared->staging();
  const Effects effects =
      effects_of(staging.scene, staging.camera) | effects_of(view_) | added_ | effect::bins | method_;
  if (const Result<Done> checked = check_visibility(effects); !checked) return checked.failure();
  Budget budget = budget_;
  if (temporal_) budget.modes = Modes::streamed;
  const SceneCounts counts = count(staging.scene);
  const auto [status, plan] = plan_within(budget, counts, effects);
  if (status.error == Error::arena_too_small) {
    return too_little_memory(status, staging.scene, view_, effects, budget, row_step_ == 1);
  }
  if (status.error == Error::unplannable) {
    return Failure{ExitStatus::usage, fmt::format("{}; ask for larger strips", message(status.error))};
  }
  if (status.error == Error::edges) {
    return Failure{ExitStatus::usage, fmt::format("{}; use --no-edges", message(status.error))};
  }
  if (!status) return frame_refused("the picture cannot be planned", status);
  return render(staging, plan);
}

Result<Done> FrameRenderer::draw(const Staging& staging, const Effects& effects, FrameReport& report) {
  const Plan& plan = report.plan;
  const std::span<std::byte> arena = at_least(memory_[0].arena, plan.bytes());
  const std::span<std::byte> strip = at_least(memory_[0].strip, report.strip_pixel_bytes);
  AnyRenderer renderer(effects);
  VisibilityOptions options = options_;
  options.tree = &staging.tree;
  if (temporal_) {
    seen_.resize(seen_words(count(staging.scene).meshlets));
    options.seen_before = seen_;
  }
  renderer.set_visibility(options);
  const Status begun = renderer.begin_frame(staging.scene, staging.camera, view_, plan, arena);
  if (!begun) return frame_refused("the frame cannot begin", begun);
  const hal::StripLayout layout{plan.strips, plan.strip_rows, plan.strip_columns};
  const auto shown = [&] {
    if (panel_ == nullptr) return hal::present(renderer, display_, layout, {strip, {}});
    DisplayPair both(display_, *panel_);
    const hal::StripBuffers buffers{strip, at_least(memory_[0].second_strip, report.strip_pixel_bytes)};
    // A method may keep something for the next frame.
    if (method_.methods != 0) return hal::present(renderer, both, layout, buffers);
    CountedFrame frame(renderer, staging.camera, staging.version);
    const auto result = hal::present(frame, both, layout, buffers);
    report.drawn_strips = frame.drawn;
    return result;
  }();
  if (!shown.draw) return frame_refused("a strip cannot be drawn", shown.draw);
  if (shown.display != hal::Error::none) return Failure{ExitStatus::internal, hal::message(shown.display)};
  report.mode = renderer.frame().mode();
  report.statistics = renderer.frame().statistics();
  report.bounds = renderer.frame().bounds();
  report.visibility = renderer.frame().visibility();
  return Done{};
}

Result<Done> FrameRenderer::draw_on_threads(const Staging& staging, const Effects& effects, FrameReport& report) {
  struct Worker {
    AnyRenderer renderer;
    Statistics after_begin{};
    bool begun = false;
  };
  const Plan& plan = report.plan;
  std::vector<Worker> workers(memory_.size(), Worker{.renderer = AnyRenderer(effects)});
  Result<Done> drawn = for_each_on_threads(
      plan.strips, static_cast<unsigned>(workers.size()), [&](unsigned thread, std::uint32_t index) {
        Worker& worker = workers[thread];
        if (!worker.begun) {
          const std::span<std::byte> arena = at_least(memory_[thread].arena, plan.bytes());
          const Status begun = worker.renderer.begin_frame(staging.scene, staging.camera, view_, plan, arena);
          if (!begun) return Result<Done>(frame_refused("the frame cannot begin", begun));
          worker.after_begin = worker.renderer.frame().statistics();
          worker.begun = true;
        }
        const auto strip = static_cast<std::uint16_t>(index);
        const std::span<std::byte> pixels = at_least(memory_[thread].strip, report.strip_pixel_bytes);
        const Status status = worker.renderer.draw_strip(strip, pixels);
        if (!status) return Result<Done>(frame_refused("a strip cannot be drawn", status));
        const Rect area = plan.strip_area(strip, view_);
        const hal::Error error =
            display_.write({static_cast<std::uint16_t>(area.left), static_cast<std::uint16_t>(area.top),
                            static_cast<std::uint16_t>(area.width()), static_cast<std::uint16_t>(area.height())},
                           pixels);  // strips share no byte of the picture
        if (error != hal::Error::none) return Result<Done>(Failure{ExitStatus::internal, hal::message(error)});
        return Result<Done>(Done{});
      });
  if (!drawn) return drawn;
  // The work of begin_frame counts once, as with one thread.
  const auto first = std::ranges::find_if(workers, &Worker::begun);
  report.mode = first->renderer.frame().mode();
  report.bounds = first->renderer.frame().bounds();
  report.statistics = first->after_begin;
  for (const Worker& worker : workers) {
    if (worker.begun) add(report.statistics, worker.renderer.frame().statistics(), worker.after_begin);
  }
  return Done{};
}

Result<FrameReport> FrameRenderer::render(const Staging& placed, const Plan& plan) {
  Staging staging = placed;
  std::vector<Instance> instances(placed.scene.instances.begin(), placed.scene.instances.end());
  if (!placed.levels.empty()) {
    choose_levels(placed.levels, placed.scene, placed.camera, instances);
    staging.scene.instances = instances;
  }
  const Effects effects =
      effects_of(staging.scene, staging.camera) | effects_of(view_) | added_ | effect::statistics | method_;
  FrameReport report;
  report.plan = plan;
  report.method = method_;
  report.strip_pixel_bytes = plan.strip_pixel_bytes(view_);
  report.drawn_strips = plan.strips;

  const auto start = std::chrono::steady_clock::now();
  // Renderers that move a skin write into its Skinning.
  const bool alone = memory_.size() == 1 || plan.strips == 1 || panel_ != nullptr || method_.methods != 0 ||
                     effects.has(effect::skins);
  const Result<Done> drawn = alone ? draw(staging, effects, report) : draw_on_threads(staging, effects, report);
  const auto end = std::chrono::steady_clock::now();
  if (!drawn) return drawn.failure();

  report.nanoseconds = std::chrono::duration_cast<std::chrono::nanoseconds>(end - start).count();
  report.crc32 = checksum(display_.pixels());
  return report;
}

}  // namespace zstrip::sim
