// Draws the shadow map as a separate frame, in the memory of the frame that then gets the shadow.
#pragma once

#include "zstrip/effects/shadows/kept.hpp"
#include "zstrip/effects/shadows/light_view.hpp"
#include "zstrip/effects/stage.hpp"

namespace zstrip::detail::shadows {

/// Checks that the plan has memory for a map, whose z-buffer uses that of the strips.
Status check_memory(const FrameRequest& request);

inline bool casts(const Scene& scene, const Instance& instance) {
  const Material& material = scene.materials[instance.material];
  return casts_shadow(scene.meshes[instance.mesh].shadow) && material.depth_write && !is_blended(scene, material);
}

/// Initialises and returns the state, whose scene has the shadow's light last.
ShadowState& begin_state(FrameState& frame, const Scene& scene);
/// Prepares the instances and strips of `light`, a separate frame in the memory of `frame`.
Status prepare_map(FrameState& light, const FrameState& frame, const Scene& casters, const LightReach& reach,
                   ShadowState& state);
Status prepare_place(FrameState& frame, const Camera& camera, Effects called_for, std::uint32_t least);
/// Returns a strip of the map with a cleared z-buffer.
StripTarget map_strip(FrameState& light, std::uint16_t strip);
Status keep_strip(const FrameState& light, std::uint16_t strip, ShadowState& state);

}  // namespace zstrip::detail::shadows
