// Which instances are lit at their pixels; only renderers with effect::pixel_shading link it.
#include "zstrip/effects/outlines/outline.hpp"
#include "zstrip/frame/frame_inline.hpp"

namespace zstrip {

void Frame::Access::EffectStage::prepare_pixel_shading(Frame& frame) {
  const Scene& scene = *frame.scene_;
  for (detail::CompiledInstance& compiled : std::span(frame.instances_, scene.instances.size())) {
    const Mesh& mesh = scene.meshes[compiled.mesh];
    if (!compiled.visible || detail::is_outline(compiled) ||
        !is_lit_by_pixel(mesh, scene.materials[compiled.material])) {
      continue;
    }
    // Vertices have their own colour and no light; lights and ambient light have the material's already.
    compiled.lit = false;
    compiled.base = {255, 255, 255, 255};
    compiled.shade = detail::with_lit_fragments(compiled.shade);
  }
}

}  // namespace zstrip
