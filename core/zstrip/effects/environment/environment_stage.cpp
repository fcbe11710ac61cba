// Which instances mirror the surroundings, and what their vertices need for it; only renderers with
// effect::environment link it.
#include "zstrip/effects/outlines/outline.hpp"
#include "zstrip/frame/frame_inline.hpp"

namespace zstrip {

void Frame::Access::EffectStage::prepare_reflections(Frame& frame, const Camera& camera, Effects called_for) {
  const Scene& scene = *frame.scene_;
  const detail::EffectBlock block = effect_block(frame);
  const SceneCounts counts = count(scene);
  const std::uint32_t vertices = frame.plan_.mode == Mode::binned ? counts.vertices : counts.largest_meshlet;
  block.reflections().first =
      vertices * (kVertexBytes + (detail::has_vertex_colours(called_for) ? kVertexColourBytes : 0));
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    detail::CompiledInstance& compiled = frame.instances_[i];
    const Mesh& mesh = scene.meshes[scene.instances[i].mesh];
    const Material& material = scene.materials[scene.instances[i].material];
    if (!compiled.visible || detail::is_outline(compiled) || !mirrors_surroundings(scene, mesh, material)) continue;
    block.eye_forms(i) = detail::eye_forms(mesh, scene.instances[i].transform, camera);
    // As if the mesh had texture coordinates.
    if (!material.lit) {
      compiled.coloured = false;
      compiled.shade = detail::Shade::textured;
    } else {
      compiled.shade = material.smooth ? detail::Shade::textured_gouraud : detail::Shade::textured_flat;
    }
  }
}

}  // namespace zstrip
