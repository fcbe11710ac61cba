// Computes texture coordinates for a meshlet's vertices from an environment map.
#pragma once

#include "zstrip/effects/environment/kept.hpp"
#include "zstrip/effects/outlines/outline.hpp"
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

}  // namespace zstrip::detail::environment
