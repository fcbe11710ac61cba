// Finds the instances that are lit at their pixels; only renderers with effect::pixel_shading link it.
#include "zstrip/effects/pixel_shading/pixel_shading_stage.hpp"

#include "zstrip/effects/outlines/outline.hpp"

namespace zstrip::detail::pixel_shading {

void prepare(FrameState& frame) {
  const Scene& scene = *frame.scene;
  for (CompiledInstance& compiled : std::span(frame.instances, scene.instances.size())) {
    const Mesh& mesh = scene.meshes[compiled.mesh];
    if (!compiled.visible || is_outline(compiled) || !is_lit_by_pixel(mesh, scene.materials[compiled.material])) {
      continue;
    }
    // Vertices keep their own colour without light; other light already contains the material's.
    compiled.lit = false;
    compiled.base = {255, 255, 255, 255};
    compiled.shade = with_lit_fragments(compiled.shade);
  }
}

}  // namespace zstrip::detail::pixel_shading
