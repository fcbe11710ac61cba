// Counts the parts of a scene that a plan depends on.
#pragma once

#include "zstrip/budget.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/store/store_bytes.hpp"

namespace zstrip {

namespace detail {

/// True if the vertices of an instance have other colours than the mesh: it is lit, or its material tints them.
constexpr bool makes_colours(const Scene& scene, const Instance& instance) {
  if (instance.mesh >= scene.meshes.size() || instance.material >= scene.materials.size()) return true;
  const Mesh& mesh = scene.meshes[instance.mesh];
  const Material& material = scene.materials[instance.material];
  if (material.lit && !mesh.normals.empty()) return true;
  return !mesh.colours.empty() && material.colour != Colour{255, 255, 255, 255};
}

}  // namespace detail

constexpr SceneCounts count(const Scene& scene) {
  SceneCounts counts{.instances = static_cast<std::uint32_t>(scene.instances.size()),
                     .quadrics = static_cast<std::uint32_t>(scene.quadrics.size()),
                     .line_sets = static_cast<std::uint32_t>(scene.lines.size())};
  const auto raise = [](std::uint32_t& largest, std::uint32_t value) { largest = largest < value ? value : largest; };
  // No sum wraps: a count of more than 32 bits becomes the maximum, which every plan refuses.
  const auto add = [](std::uint32_t& sum, std::uint64_t value) {
    const std::uint64_t wide = sum + value;
    sum = wide < 0xFFFFFFFF && value < 0xFFFFFFFF ? static_cast<std::uint32_t>(wide) : 0xFFFFFFFF;
  };
  const auto add_mesh = [&](const Mesh& mesh) {
    const auto vertices = static_cast<std::uint32_t>(mesh.positions.size());
    const auto triangles = static_cast<std::uint32_t>(mesh.triangles.size());
    add(counts.triangles, triangles);
    if (mesh.meshlets.empty()) {
      add(counts.vertices, vertices);
      add(counts.meshlets, 1);
      raise(counts.largest_meshlet, vertices);
      raise(counts.longest_meshlet, triangles);
    }
    add(counts.meshlets, mesh.meshlets.size());
    for (const Meshlet& meshlet : mesh.meshlets) {
      add(counts.vertices, meshlet.vertex_count);
      raise(counts.largest_meshlet, meshlet.vertex_count);
      raise(counts.longest_meshlet, meshlet.triangle_count);
    }
  };
  for (const Instance& instance : scene.instances) {
    std::uint32_t index = instance.mesh;
    for (const Outline* outline = nullptr; index < scene.meshes.size();) {
      add_mesh(scene.meshes[index]);
      if (outline != nullptr || (outline = outline_of(scene, scene.meshes[index])) == nullptr) break;
      index = hull_of(*outline, instance);
      add(counts.instances, 1);
    }
  }
  if (scene.shadow != nullptr && scene.shadow->log2_size <= kMaxShadowLog2) {
    counts.shadow_side = 1U << scene.shadow->log2_size;
    counts.shadow_pool =
        scene.shadow->pool != 0 ? scene.shadow->pool : store_bytes_worst(counts.shadow_side, counts.shadow_side);
  }
  counts.colours_in_place = scene.outlines.empty();
  for (const Instance& instance : scene.instances) {
    if (detail::makes_colours(scene, instance)) counts.colours_in_place = false;
  }
  counts.csg_operands = static_cast<std::uint32_t>(scene.csg.size());
  counts.edge_groups = edge_groups(scene);
  return counts;
}

}  // namespace zstrip
