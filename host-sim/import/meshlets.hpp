// Cuts a mesh of any size into meshlets, and collects these in meshes that 16-bit indices can address.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "import/model.hpp"

namespace zstrip::sim {

inline constexpr std::size_t kMeshletVertices = 64;
inline constexpr std::size_t kMeshletTriangles = 124;
/// The largest meshlet, at most of the two constants; `triangles` is a multiple of four.
struct MeshletLimits {
  std::size_t vertices = kMeshletVertices, triangles = kMeshletTriangles;
};

inline constexpr std::size_t kMaxMeshVertices = 65535;

/// `whole` has the vertices (its triangles and meshlets are not read), `indices` three indices for each triangle;
/// `half_extent` is that of the grid (16.16). The vertices of a meshlet are adjacent; vertices on its border are in
/// each meshlet that uses them. The result has every triangle once, and is empty without triangles.
std::vector<MeshData> split_into_meshlets(const MeshData& whole, std::span<const std::uint32_t> indices,
                                          const Vec3& half_extent, const MeshletLimits& limits = {});

/// Sets centre and radius of a meshlet with these vertices, in a mesh with this half extent (16.16).
void set_bounds(Meshlet& meshlet, std::span<const Position> positions, const Vec3& half_extent);

}  // namespace zstrip::sim
