// Finds the instances that are drawn fragment by fragment.
#pragma once

#include <span>

#include "zstrip/effects/stage.hpp"

namespace zstrip::detail::fragments {

struct Stage : NoStage {
  static constexpr Effects kEffects = effect::fragments;

  template <Effects effects>
  static Status prepare(FrameState& frame, const FrameRequest&) {
    const Scene& scene = *frame.scene;
    for (CompiledInstance& instance : std::span(frame.instances, scene.instances.size())) {
      if (!instance.visible) continue;
      const Effects finish =
          effects_of_finish(scene, scene.materials[instance.material], instance.lit, instance.shade >= Shade::textured);
      if (scene.fog != nullptr || finish.any(effect::fragments)) instance.shade = with_fragments(instance.shade);
      if constexpr (effects.has(effect::dithered_colours)) {
        const bool varies = instance.shade == Shade::gouraud || instance.shade == Shade::textured_gouraud;
        if (varies && dithers_colours(frame.view)) instance.shade = with_fragments(instance.shade);
      }
    }
    return {};
  }
};

}  // namespace zstrip::detail::fragments
