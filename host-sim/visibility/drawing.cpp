// Plans and draws a frame with a visibility method, and reads its results strip by strip.
#include "visibility/drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "render/frame_refused.hpp"
#include "text/number.hpp"
#include "visibility/methods.hpp"
#include "zstrip/renderer.hpp"

namespace zstrip::sim {
namespace {

Effects effects_for(const Staging& staging, const MethodRequest& request) {
  return effects_of(staging.scene, staging.camera) | effects_of(request.view) | request.effects | effect::bins;
}

Result<Plan> planned(const Staging& staging, const MethodRequest& request, Effects effects) {
  if (const Result<Done> checked = check_visibility(effects); !checked) return checked.failure();
  const auto [status, plan] = zstrip::plan(count(staging.scene), request.view, effects, request.budget);
  if (status) return plan;
  if (status.error == Error::arena_too_small) {
    return Failure{ExitStatus::budget, fmt::format("RAM of {} is too little: {} needed, most of them for {}",
                                                   counted(request.budget.bytes, "byte"),
                                                   counted(status.needed, "byte"), name(status.purpose))};
  }
  return Failure{ExitStatus::usage, fmt::format("the picture cannot be planned: {}", message(status.error))};
}

std::span<std::byte> bytes_of(std::vector<std::uint64_t>& words, std::uint32_t bytes) {
  words.resize((std::size_t{bytes} + 7) / 8);
  return std::as_writable_bytes(std::span(words)).first(bytes);
}

/// Copies the results of a strip to their place in the frame.
void look_at(FrameWithMethod frame, Effects effects, const Rect& strip, std::span<const std::byte> pixels,
             std::span<const std::uint8_t> overdraw, LookedAtFrame& looked) {
  const std::uint32_t width = looked.view.width;
  const auto* const colours = reinterpret_cast<const std::uint16_t*>(pixels.data());
  for (std::int32_t y = strip.top; y < strip.bottom; ++y) {
    std::copy_n(colours + std::ptrdiff_t{y - strip.top} * strip.width(), strip.width(),
                looked.pixels.begin() + y * static_cast<std::ptrdiff_t>(width) + strip.left);
  }
  const Rect& area = frame.depth_area();
  const bool wide = depth_bytes(depth_format(effects)) == 4;
  for (std::int32_t y = area.top; y < area.bottom; ++y) {
    for (std::int32_t x = area.left; x < area.right; ++x) {
      const auto cell = static_cast<std::size_t>((y - area.top) * area.width() + x - area.left);
      const std::size_t at = static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x);
      if (!effects.has(method::painter)) {
        const std::uint32_t code = wide ? frame.wide_depth()[cell] : frame.depth()[cell];
        looked.depth[at] = code > frame.cleared_code() ? code - frame.cleared_code() : 0;
      }
      if (effects.methods != 0) looked.overdraw[at] = overdraw[cell];
      if (effects.any(method::bounded)) looked.tiles[at] = frame.farthest_known(x, y);
    }
  }
}

}  // namespace

Result<LookedAtFrame> draw_looked_at(const Staging& original, const MethodRequest& request) {
  const Result<PreparedScene> prepared = PreparedScene::of(original, request.effects);
  if (!prepared) return prepared.failure();
  const Staging staging = prepared->staging();
  const Effects effects = effects_for(staging, request) | effect::statistics;
  const Result<Plan> plan = planned(staging, request, effects);
  if (!plan) return plan.failure();
  const std::size_t pixels = std::size_t{request.view.width} * request.view.height;
  LookedAtFrame looked{.view = request.view,
                       .plan = *plan,
                       .pixels = std::vector<std::uint16_t>(pixels),
                       .depth = std::vector<std::uint32_t>(pixels),
                       .overdraw = std::vector<std::uint8_t>(pixels),
                       .tiles = std::vector<std::uint16_t>(pixels)};
  std::vector<std::uint64_t> arena, strip;
  std::vector<std::uint8_t> overdraw(std::size_t{plan->strip_rows} * plan->strip_columns);
  const std::span<std::byte> strip_bytes = bytes_of(strip, plan->strip_pixel_bytes(request.view));
  VisibilityOptions options = request.options;
  options.overdraw = overdraw.data();
  options.tree = &staging.tree;
  AnyRenderer renderer(effects);
  renderer.set_visibility(options);
  const auto start = std::chrono::steady_clock::now();
  if (const Status begun =
          renderer.begin_frame(staging.scene, staging.camera, request.view, *plan, bytes_of(arena, plan->bytes()));
      !begun) {
    return frame_refused("the frame cannot be drawn", begun);
  }
  for (std::uint16_t i = 0; i < plan->strips; ++i) {
    if (const Status drawn = renderer.draw_strip(i, strip_bytes); !drawn)
      return frame_refused("the frame cannot be drawn", drawn);
    look_at(renderer.frame(), effects, plan->strip_area(i, request.view), strip_bytes, overdraw, looked);
  }
  looked.nanoseconds =
      std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now() - start).count();
  looked.pieces_split = prepared->splits();
  looked.mode = renderer.frame().mode();
  looked.statistics = renderer.frame().statistics();
  looked.visibility = renderer.frame().visibility();
  looked.nearest = renderer.frame().nearest();
  looked.farthest = renderer.frame().farthest();
  return looked;
}

TimedDrawing::TimedDrawing(PreparedScene scene, const MethodRequest& request, Effects effects, const Plan& plan)
    : scene_(std::move(scene)),
      request_(request),
      effects_(effects),
      plan_(plan),
      arena_((plan.bytes() + 7) / 8),
      strip_((plan.strip_pixel_bytes(request.view) + 7) / 8) {}

Result<TimedDrawing> TimedDrawing::prepare(const Staging& original, const MethodRequest& request) {
  Result<PreparedScene> prepared = PreparedScene::of(original, request.effects);
  if (!prepared) return prepared.failure();
  const Staging staging = prepared->staging();
  const Effects effects = effects_for(staging, request);
  const Result<Plan> plan = planned(staging, request, effects);
  if (!plan) return plan.failure();
  return TimedDrawing(std::move(*prepared), request, effects, *plan);
}

Status TimedDrawing::draw() {
  // Only plans with bins use them; each method has a pipeline without bins that does not count.
  const Pipeline pipeline = pipeline_for(plan_.mode == Mode::binned ? effects_ : without(effects_, effect::bins));
  detail::MethodFrameState frame;
  const Staging staging = scene_.staging();
  VisibilityOptions options = request_.options;
  options.tree = &staging.tree;
  frame.options = options;
  const std::span<std::byte> arena = bytes_of(arena_, plan_.bytes());
  if (const Status begun = pipeline.begin_frame(frame, staging.scene, staging.camera, request_.view, plan_, arena);
      !begun) {
    return begun;
  }
  for (std::uint16_t i = 0; i < plan_.strips; ++i) {
    const Status drawn = pipeline.draw_strip(frame, i, bytes_of(strip_, plan_.strip_pixel_bytes(request_.view)));
    if (!drawn) return drawn;
  }
  return {};
}

}  // namespace zstrip::sim
