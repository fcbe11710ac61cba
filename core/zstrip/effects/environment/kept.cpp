// Finds the instances with an environment map, and prepares the data for their vertices; only renderers with
// effect::environment link it.
#include "zstrip/effects/environment/kept.hpp"

#include "zstrip/effects/outlines/outline.hpp"

namespace zstrip::detail::environment {

void prepare(FrameState& frame, const Camera& camera, Effects called_for) {
  const Scene& scene = *frame.scene;
  const SceneCounts counts = count(scene);
  const std::uint32_t vertices = frame.plan.mode == Mode::binned ? counts.vertices : counts.largest_meshlet;
  reflections_of(frame).first = vertices * coloured_bytes_per_vertex(called_for, counts);
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    CompiledInstance& compiled = frame.instances[i];
    const Mesh& mesh = scene.meshes[scene.instances[i].mesh];
    const Material& material = scene.materials[scene.instances[i].material];
    if (!compiled.visible || is_outline(compiled) || !has_environment_map(scene, mesh, material)) continue;
    eye_forms_of(frame, i) = detail::eye_forms(mesh, scene.instances[i].transform, camera);
    // Shades the instance as if the mesh had texture coordinates.
    if (!material.lit) {
      compiled.coloured = false;
      compiled.shade = Shade::textured;
    } else {
      compiled.shade = material.smooth ? Shade::textured_gouraud : Shade::textured_flat;
    }
  }
}

}  // namespace zstrip::detail::environment
