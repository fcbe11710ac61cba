// The triangles of a meshlet and the vertices that they use.
#pragma once

#include <cstdint>
#include <span>

#include "zstrip/scene.hpp"

namespace zstrip::detail {

struct MeshletRange {
  std::uint32_t first_vertex, vertex_count;
  std::span<const Triangle> triangles;
};

/// Returns the number of meshlets; a mesh without a table of meshlets is one meshlet.
constexpr std::uint32_t meshlet_count(const Mesh& mesh) {
  return mesh.meshlets.empty() ? 1 : static_cast<std::uint32_t>(mesh.meshlets.size());
}

inline MeshletRange meshlet_range(const Mesh& mesh, std::uint32_t index) {
  if (mesh.meshlets.empty()) return {0, static_cast<std::uint32_t>(mesh.positions.size()), mesh.triangles};
  const Meshlet& meshlet = mesh.meshlets[index];
  return {meshlet.first_vertex, meshlet.vertex_count,
          mesh.triangles.subspan(meshlet.first_triangle, meshlet.triangle_count)};
}

}  // namespace zstrip::detail
