// Computes texture coordinates for the vertices of instances with an environment map.
#pragma once

#include "zstrip/effects/environment/kept.hpp"
#include "zstrip/effects/outlines/outline.hpp"
#include "zstrip/effects/stage.hpp"
#include "zstrip/geometry/meshlet_range.hpp"
#include "zstrip/raster/attributes.hpp"

namespace zstrip::detail::environment {

/// Returns the reflections of an instance's vertices, or null if it has no environment map.
inline TexCoord* reflections_of(const FrameState& frame, std::uint32_t instance, std::uint32_t cache) {
  const Scene& scene = *frame.scene;
  const CompiledInstance& compiled = frame.instances[instance];
  if (is_outline(compiled) ||
      !has_environment_map(scene, scene.meshes[compiled.mesh], scene.materials[compiled.material])) {
    return nullptr;
  }
  auto* const vertices = reinterpret_cast<std::byte*>(frame.vertices);
  return reinterpret_cast<TexCoord*>(vertices + reflections_of(frame).first) + cache;
}

template <bool orthographic>
void reflect(const FrameState& frame, const ReflectingBatch& batch, const MeshletRange& range) {
  const EyeForms& forms = eye_forms_of(frame, static_cast<std::size_t>(batch.instance - frame.instances));
  const TextureView& texture = batch.surface.texture;
  for (std::uint32_t i = 0; i < range.vertex_count; ++i) {
    const std::uint32_t vertex = range.first_vertex + i;
    const MirroredPoint point = mirrored_point<orthographic>(forms, batch.mesh->positions[vertex],
                                                             batch.mesh->normals[vertex], batch.instance->double_sided);
    batch.reflections[vertex - batch.first_vertex] = texcoord_of(point, texture.log2_width, texture.log2_height);
  }
}

struct Stage : NoStage {
  static constexpr Effects kEffects = effect::environment;

  template <Effects effects>
  static Status check(const FrameRequest& request) {
    const SceneCounts& counts = request.counts;
    const std::uint64_t vertices = request.plan.mode == Mode::binned ? counts.vertices : counts.largest_meshlet;
    const std::uint64_t needed = vertices * bytes_per_vertex(request.called_for, counts);
    if (request.plan.vertex_bytes >= needed) return {};
    return too_small(Purpose::vertices, needed, request.plan.vertex_bytes);
  }
  template <Effects effects>
  static Status prepare(FrameState& frame, const FrameRequest& request) {
    if (!request.called_for.has(effect::environment)) return {};
    environment::prepare(frame, request.camera, request.called_for);
    return {};
  }
};

}  // namespace zstrip::detail::environment
