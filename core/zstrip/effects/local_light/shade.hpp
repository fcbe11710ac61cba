// Computes the colours of a meshlet's vertices with light that depends on their position.
#pragma once

#include "zstrip/effects/local_light/kept.hpp"
#include "zstrip/geometry/meshlet_range.hpp"
#include "zstrip/raster/attributes.hpp"

namespace zstrip::detail::local_light {

/// Returns false if the instance has only ambient and directional light.
template <Effects effects>
bool shade(FrameState& frame, const Batch& batch, const MeshletRange& range, std::uint32_t cache) {
  const Scene& scene = *frame.scene;
  const CompiledInstance& instance = *batch.instance;
  const Material& material = scene.materials[instance.material];
  if (!effects_of_finish(scene, material, instance.lit, false).any(effect::vertex_light)) return false;
  const Finish finish = finish_of(scene, material);
  const FrameLights* lights = nullptr;
  const InstanceShading* shading = nullptr;
  if (effect_block(frame).has(effect::local_light)) {
    lights = &lights_of(frame);
    shading = &shading_of(frame, static_cast<std::size_t>(batch.instance - frame.instances));
    if constexpr (effects.has(effect::statistics)) {
      auto& work = frame.statistics.work;
      work[WorkKind::lights_of_vertices] += range.vertex_count * lights->count;
      if (!is_black(finish.specular)) {
        work[WorkKind::shining_vertices] += range.vertex_count * (lights->count + instance.light_count);
      }
    }
  }
  for (std::uint32_t i = 0; i < range.vertex_count; ++i) {
    const std::uint32_t vertex = range.first_vertex + i;
    const Colour lit = locally_lit_colour<effects>(instance, *batch.mesh, vertex, scene, lights, shading, finish);
    frame.colours[cache + i] = with_vertex_colour<effects>(lit, instance, *batch.mesh, vertex);
  }
  return true;
}

}  // namespace zstrip::detail::local_light
