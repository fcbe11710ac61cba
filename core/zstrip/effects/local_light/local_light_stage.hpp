// Prepares a frame's data for light that depends on the position of a vertex.
#pragma once

#include "zstrip/effects/local_light/kept.hpp"
#include "zstrip/effects/stage.hpp"

namespace zstrip::detail::local_light {

inline void prepare(const FrameState& frame, const Camera& camera) {
  const Scene& scene = *frame.scene;
  lights_of(frame) = frame_lights(scene, camera);
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const Instance& instance = scene.instances[i];
    shading_of(frame, i) = instance_shading(scene.meshes[instance.mesh], instance.transform, camera);
  }
}

struct Stage : NoStage {
  static constexpr Effects kEffects = effect::local_light;

  template <Effects effects>
  static Status prepare(FrameState& frame, const FrameRequest& request) {
    if (request.called_for.any(effect::local_light)) local_light::prepare(frame, request.camera);
    return {};
  }
};

}  // namespace zstrip::detail::local_light
