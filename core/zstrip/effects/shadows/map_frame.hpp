// The shadow map as a frame of its own: in the memory of the one that gets the shadow, before that is drawn.
#pragma once

#include "zstrip/effects/shadows/kept.hpp"
#include "zstrip/effects/shadows/light_view.hpp"
#include "zstrip/effects/stage.hpp"

namespace zstrip::detail::shadows {

/// Whether the plan has the memory for a map, whose z-buffer is that of the strips.
Status check_memory(const FrameRequest& request);

inline bool casts(const Scene& scene, const Instance& instance) {
  const Material& material = scene.materials[instance.material];
  return casts_shadow(scene.meshes[instance.mesh].shadow) && material.depth_write && !is_blended(scene, material);
}

/// The state, with the scene's lights in its order.
ShadowState& begin_state(FrameState& frame, const Scene& scene);
/// Instances of `light`, a frame of its own in the memory of `frame`, and its strips.
Status prepare_map(FrameState& light, const FrameState& frame, const Scene& casters, const LightReach& reach,
                   ShadowState& state);
Status prepare_place(FrameState& frame, const Camera& camera, Effects called_for, std::uint32_t least);
/// Its z-buffer, cleared.
StripTarget map_strip(FrameState& light, std::uint16_t strip);
Status keep_strip(const FrameState& light, std::uint16_t strip, ShadowState& state);

}  // namespace zstrip::detail::shadows
