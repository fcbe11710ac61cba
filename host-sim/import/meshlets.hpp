// Cuts a mesh of any size into meshlets, and gathers these into meshes that 16-bit indices can address.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "import/model.hpp"

namespace zstrip::sim {

inline constexpr std::size_t kMeshletVertices = 64;
inline constexpr std::size_t kMeshletTriangles = 124;
inline constexpr std::size_t kMaxMeshVertices = 65535;

/// `whole` gives the vertices (its triangles and meshlets are not read), `indices` three for each triangle;
/// `half_extent` is that of the grid (16.16). The vertices of a meshlet lie together; those on its border are in each
/// meshlet that uses them. Every triangle comes out once.
std::vector<MeshData> split_into_meshlets(const MeshData& whole, std::span<const std::uint32_t> indices,
                                          const Vec3& half_extent);

/// Centre and radius of a meshlet with these vertices, in a mesh with this half extent (16.16).
void set_bounds(Meshlet& meshlet, std::span<const Position> positions, const Vec3& half_extent);

}  // namespace zstrip::sim
