// The checks that depend on the renderer's projection, depth format and methods.
#pragma once

#include <cstddef>
#include <span>

#include "zstrip/effects/stage.hpp"
#include "zstrip/stages/depth_stage.hpp"
#include "zstrip/state/checks.hpp"

namespace zstrip::detail {

/// Checks the parts of a request that only some renderers restrict.
template <Effects effects>
Status check_own_request(const FrameRequest& request) {
  [[maybe_unused]] const Plan& plan = request.plan;
  if constexpr (effects.has(effect::orthographic)) {
    // A pipeline has one projection: it must not have this effect unless the camera is orthographic.
    if (request.camera.projection != Projection::orthographic) return {.error = Error::effect_missing};
  }
  if constexpr (effects.has(effect::depth_ranges)) {
    // Binned vertices keep the depth of the sub-range in which they were transformed.
    if (plan.mode == Mode::binned) return {.error = Error::depth_effects};
  }
  if constexpr (MemoryOfEffects::has_any(effects)) {
    const std::uint64_t needed = MemoryOfEffects::bytes<effects>(request.called_for, request.counts);
    if (plan.effect_bytes < needed) return too_small(Purpose::effects, needed, plan.effect_bytes);
  }
  if constexpr (depth_bytes(depth_format(effects)) != kDepthBytes) {
    const std::uint64_t needed =
        std::uint64_t{plan.strip_rows} * plan.strip_columns * depth_bytes(depth_format(effects));
    if (plan.depth_bytes < needed) return too_small(Purpose::depth, needed, plan.depth_bytes);
  }
  return {};
}

template <Effects effects>
Status check_strip(const FrameState& frame, std::uint16_t strip, std::span<const std::byte> pixels) {
  if constexpr (effects.has(effect::supersampled)) return check_strip_of_samples(frame, strip, pixels);
  return check_strip(frame, strip, pixels);
}

/// draw_over works with 16-bit cells and without a method.
constexpr bool can_draw_over(Effects effects) { return effects.methods == 0 && !DepthStage::has_own_clear(effects); }
template <Effects effects>
Status check_area(const FrameState& frame, const Rect& area, std::size_t pixels, std::size_t depths) {
  if (effects.methods != 0) return {.error = Error::visibility, .needed = effects.methods};
  if (!can_draw_over(effects)) return {.error = Error::depth_effects};
  return check_area(frame, area, pixels, depths);
}

}  // namespace zstrip::detail
