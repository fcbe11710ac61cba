// The parts of a frame that do not depend on effects: its memory, its instances, its strips, and the target of a strip.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip/pixels/target.hpp"
#include "zstrip/plan/record_bytes.hpp"
#include "zstrip/plan/scene_counts.hpp"
#include "zstrip/state/effect_block.hpp"
#include "zstrip/state/frame_state.hpp"

namespace zstrip::detail {

/// Ends the frame: nothing is drawn until a new frame has begun.
inline void abandon(FrameState& frame) {
  frame.scene = nullptr;
  frame.next_to_last_strip = 0;
}

/// Returns the error for a part of the plan; both numbers are bytes.
constexpr Status too_small(Purpose purpose, std::uint64_t needed, std::uint32_t available) {
  return {.error = Error::arena_too_small,
          .purpose = purpose,
          .needed = static_cast<std::uint32_t>(needed),
          .available = available};
}

void lay_out_arena(FrameState& frame, std::span<std::byte> arena);
/// Sets view and plan of the frame, which have been checked, lays out the arena and resets the statistics.
inline void start(FrameState& frame, const View& view, const Plan& plan, std::span<std::byte> arena) {
  frame.view = view;
  frame.plan = plan;
  frame.mode = plan.mode;
  frame.statistics = {};
  lay_out_arena(frame, arena);
}

/// Prepares the frame before its instances. `counts` are those of the drawn scene.
void begin_instances(FrameState& frame, const SceneCounts& counts, const Camera& camera, const View& view,
                     const DepthFit& fit);
/// Finds out if a compiled instance is visible, and extends the frame's bounds.
void bound_instance(FrameState& frame, CompiledInstance& instance, const Camera& camera, const View& view);
/// Compiles the instances and finds the frame's bounds.
template <Effects effects>
Status prepare_instances(FrameState& frame, const Scene& scene, const SceneCounts& counts, const Camera& camera,
                         const View& view, const DepthFit& fit) {
  constexpr bool kOrthographic = effects.has(effect::orthographic);
  constexpr bool kLights = effects.any(effect::lighting | effect::pixel_shading);
  begin_instances(frame, counts, camera, view, fit);
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
    CompiledInstance& instance = frame.instances[i];
    instance.visible = false;
    if (frame.fit.near == 0) continue;  // nothing is in the depth range
    if (const Status status =
            compile_instance<kOrthographic, kLights>(instance, scene, scene.instances[i], camera, view, frame.fit);
        !status) {
      return {.error = status.error, .needed = i};
    }
    bound_instance(frame, instance, camera, view);
  }
  return {};
}
/// Extends the bounds by `box`, pixels of the picture, not empty.
void extend_bounds(FrameState& frame, const Rect& box);
/// Divides the picture into strips, once the bounds are known.
void divide(FrameState& frame, const SceneCounts& counts, const View& view);

inline EffectBlock effect_block(const FrameState& frame) {
  return {reinterpret_cast<std::byte*>(frame.batches) + frame.plan.bin_bytes, frame.plan.effect_bytes};
}
/// Call it before any use of the effect_block.
template <Effects effects>
void lay_out_effects([[maybe_unused]] const FrameState& frame, [[maybe_unused]] const Scene& scene,
                     [[maybe_unused]] Effects called_for) {
  if constexpr (MemoryOfEffects::has_any(effects)) effect_block(frame).lay_out(called_for, count(scene).instances);
}

/// Returns the target of a strip; `strip` is its rectangle in the picture.
StripTarget target_of(FrameState& frame, Rect strip, std::uint16_t* pixels);
/// Returns the target for `area`, pixels of the picture inside the frame's bounds. The caller sets the addresses of
/// pixels and depth.
StripTarget target_at(FrameState& frame, const Rect& area);
/// Clears the target's z-buffer of 16-bit cells, and the strip's pixels.
void clear(const FrameState& frame, std::uint16_t width, std::uint16_t rows, std::uint16_t* pixels,
           const StripTarget& target);

}  // namespace zstrip::detail
