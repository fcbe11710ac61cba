// Rotates the billboards of a frame; only renderers with effect::billboards link it.
#include "zstrip/effects/billboards/billboard_stage.hpp"

#include "zstrip/effects/billboards/billboard.hpp"
#include "zstrip/scene/validate.hpp"

namespace zstrip::detail::billboards {

Status turn(const FrameState& frame, Scene& scene, const Camera& camera) {
  const std::span<Instance> turned{effect_block(frame).at<changed_instances::Memory, Instance>(),
                                   scene.instances.size()};
  for (std::uint32_t i = 0; i < turned.size(); ++i) {
    turned[i] = scene.instances[i];
    const Billboard billboard = scene.meshes[turned[i].mesh].billboard;
    if (billboard == Billboard::none) continue;
    if (!is_turnable(turned[i].transform)) return {.error = Error::instance, .needed = i};
    turned[i].transform = turned_to_viewer(turned[i].transform, billboard, camera);
  }
  scene.instances = turned;
  return {};
}

}  // namespace zstrip::detail::billboards
