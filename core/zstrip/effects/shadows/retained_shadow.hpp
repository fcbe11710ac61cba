// The vertex colours in shadow, which bins keep in a separate part of the arena.
#pragma once

#include "zstrip/effects/shadows/kept.hpp"
#include "zstrip/raster/attributes.hpp"

namespace zstrip::detail::shadows {

/// Calls shade() without the shadow's light, while frame.colours is the memory of the colours in shadow.
template <class Shade>
void shade_retained(FrameState& frame, const Batch& batch, const Shade& shade) {
  if (!effect_block(frame).has(effect::shadows) || state_of(frame).empty) return;
  CompiledInstance& instance = frame.instances[static_cast<std::size_t>(batch.instance - frame.instances)];
  Colour* const lit = frame.colours;
  frame.colours = state_of(frame).colours_in_shadow;
  leave_shadowing_light(instance, frame.scene->meshes[batch.instance->mesh], -1);
  shade();
  leave_shadowing_light(instance, frame.scene->meshes[batch.instance->mesh], 1);
  frame.colours = lit;
}

}  // namespace zstrip::detail::shadows
