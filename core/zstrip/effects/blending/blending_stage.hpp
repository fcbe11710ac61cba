// Orders instances: opaque ones first, then blended ones from far to near.
#pragma once

#include "zstrip/effects/blending/draw_order.hpp"
#include "zstrip/effects/stage.hpp"

namespace zstrip::detail::blending {

/// Puts opaque instances in the scene's order, followed by blended ones from far to near.
inline void prepare(const FrameState& frame, const Camera& camera) {
  const Scene& scene = *frame.scene;
  const std::span<DrawOrder> order = order_of(frame);
  const auto blends = [&scene](const Instance& instance) {
    return is_blended(scene, scene.materials[instance.material]);
  };
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
    if (!blends(scene.instances[i])) order[count++] = {0, i, 0};
  }
  const std::size_t first = count;
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
    const Instance& instance = scene.instances[i];
    if (!blends(instance)) continue;
    const DistanceRange range = distance_range(scene.meshes[instance.mesh], instance.transform, camera);
    const Distance middle = range.nearest / 2 + range.farthest / 2;
    std::size_t place = count++;
    for (; place > first && order[place - 1].distance < middle; --place) order[place] = order[place - 1];
    order[place] = {middle, i, 0};
  }
}

struct Stage : NoStage {
  static constexpr Effects kEffects = effect::blending;

  template <Effects effects>
  static Status prepare(FrameState& frame, const FrameRequest& request) {
    if (request.called_for.has(effect::blending)) blending::prepare(frame, request.camera);
    return {};
  }
};

}  // namespace zstrip::detail::blending
