// The colours of vertices in shadow, where bins keep vertices: a part of the arena of their own.
#pragma once

#include "zstrip/stages/frame_parts.hpp"

namespace zstrip::detail::shadows {

/// Calls shade() with the instance's light as it is in shadow and frame.colours at the part of those colours.
template <class Shade>
void shade_retained(FrameState& frame, const Batch& batch, const Shade& shade) {
  const EffectBlock block = effect_block(frame);
  if (!block.has(effect::shadows) || block.shadows().empty) return;
  CompiledInstance& instance = frame.instances[static_cast<std::size_t>(batch.instance - frame.instances)];
  Colour* const lit = frame.colours;
  frame.colours = block.shadows().colours_in_shadow;
  leave_shadowing_light(instance, frame.scene->meshes[batch.instance->mesh], -1);
  shade();
  leave_shadowing_light(instance, frame.scene->meshes[batch.instance->mesh], 1);
  frame.colours = lit;
}

}  // namespace zstrip::detail::shadows
