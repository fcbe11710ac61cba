// Light that depends on the position of a vertex: prepares a frame's data for it, and computes the colours of a
// meshlet's vertices.
#pragma once

#include "zstrip/effects/local_light/kept.hpp"
#include "zstrip/effects/stage.hpp"
#include "zstrip/geometry/meshlet_range.hpp"
#include "zstrip/raster/attributes.hpp"

namespace zstrip::detail::local_light {

inline void prepare(const FrameState& frame, const Camera& camera) {
  const Scene& scene = *frame.scene;
  lights_of(frame) = frame_lights(scene, camera);
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const Instance& instance = scene.instances[i];
    shading_of(frame, i) = instance_shading(scene.meshes[instance.mesh], instance.transform, camera);
  }
}

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
      WorkCounts& work = frame.statistics.work;
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

struct Stage : NoStage {
  static constexpr Effects kEffects = effect::local_light;

  template <Effects effects>
  static Status prepare(FrameState& frame, const FrameRequest& request) {
    if (request.called_for.any(effect::local_light)) local_light::prepare(frame, request.camera);
    return {};
  }
};

}  // namespace zstrip::detail::local_light
