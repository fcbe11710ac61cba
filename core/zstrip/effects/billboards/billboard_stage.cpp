// Turns the billboards of a frame; only renderers with effect::billboards link it.
#include "zstrip/effects/billboards/billboard.hpp"
#include "zstrip/frame/frame_inline.hpp"

namespace zstrip {

Status Frame::Access::turn_billboards(const Frame& frame, Scene& scene, const Camera& camera, Effects called_for) {
  const detail::EffectBlock block = effect_block(frame, scene);
  block.lay_out(called_for);
  const std::span<Instance> turned = block.turned();
  for (std::uint32_t i = 0; i < turned.size(); ++i) {
    turned[i] = scene.instances[i];
    const Billboard billboard = scene.meshes[turned[i].mesh].billboard;
    if (billboard == Billboard::none) continue;
    if (!detail::is_turnable(turned[i].transform)) return {.error = Error::instance, .needed = i};
    turned[i].transform = detail::turned_to_viewer(turned[i].transform, billboard, camera);
  }
  scene.instances = turned;
  return {};
}

}  // namespace zstrip
