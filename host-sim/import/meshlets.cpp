// Cuts a mesh of any size into meshlets, and collects these in meshes that 16-bit indices can address.
#include "import/meshlets.hpp"

#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace zstrip::sim {
namespace {

/// Copies `from[index]` for each index, for attributes that the mesh has.
template <typename T>
void append(std::vector<T>& to, const std::vector<T>& from, std::span<const unsigned> indices) {
  if (from.empty()) return;
  for (const unsigned index : indices) to.push_back(from[index]);
}

}  // namespace

// Centre of the bounding box, and the largest distance from it in steps of the grid's largest half extent, rounded up.
void set_bounds(Meshlet& meshlet, std::span<const Position> positions, const Vec3& half_extent) {
  std::array<int, 3> low{32767, 32767, 32767};
  std::array<int, 3> high{-32767, -32767, -32767};
  for (const Position& p : positions) {
    const std::array<int, 3> point{p.x, p.y, p.z};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], point[axis]);
      high[axis] = std::max(high[axis], point[axis]);
    }
  }
  const auto middle = [&](std::size_t axis) { return static_cast<std::int16_t>((low[axis] + high[axis]) / 2); };
  meshlet.centre = {middle(0), middle(1), middle(2)};

  const double largest = std::max({half_extent.x, half_extent.y, half_extent.z});
  double radius = 0;
  for (const Position& p : positions) {
    const double x = (p.x - meshlet.centre.x) * (half_extent.x / largest);
    const double y = (p.y - meshlet.centre.y) * (half_extent.y / largest);
    const double z = (p.z - meshlet.centre.z) * (half_extent.z / largest);
    radius = std::max(radius, std::sqrt(x * x + y * y + z * z));
  }
  // At most sqrt(3) * 32768 = 56756: half the box's diagonal.
  meshlet.radius = static_cast<std::uint16_t>(std::ceil(radius));
}

std::vector<MeshData> split_into_meshlets(const MeshData& whole, std::span<const std::uint32_t> indices,
                                          const Vec3& half_extent, const MeshletLimits& limits) {
  if (indices.empty()) return {};  // meshoptimizer would abort
  std::vector<std::array<float, 3>> points;
  points.reserve(whole.positions.size());
  for (const Position& p : whole.positions) {
    points.push_back({static_cast<float>(p.x) * static_cast<float>(half_extent.x),
                      static_cast<float>(p.y) * static_cast<float>(half_extent.y),
                      static_cast<float>(p.z) * static_cast<float>(half_extent.z)});
  }
  const std::size_t bound = meshopt_buildMeshletsBound(indices.size(), limits.vertices, limits.triangles);
  std::vector<meshopt_Meshlet> found(bound);
  std::vector<unsigned> vertices(bound * limits.vertices);
  std::vector<unsigned char> corners(bound * limits.triangles * 3);
  found.resize(meshopt_buildMeshlets(found.data(), vertices.data(), corners.data(), indices.data(), indices.size(),
                                     points[0].data(), points.size(), sizeof points[0], limits.vertices,
                                     limits.triangles, 0.0F));

  std::vector<MeshData> parts;
  for (const meshopt_Meshlet& from : found) {
    if (parts.empty() || parts.back().positions.size() + from.vertex_count > kMaxMeshVertices) parts.emplace_back();
    MeshData& part = parts.back();
    Meshlet meshlet{.first_triangle = static_cast<std::uint32_t>(part.triangles.size()),
                    .first_vertex = static_cast<std::uint16_t>(part.positions.size()),
                    .vertex_count = static_cast<std::uint16_t>(from.vertex_count),
                    .triangle_count = static_cast<std::uint16_t>(from.triangle_count),
                    .radius = 0,
                    .centre = {}};
    const std::span used(vertices.data() + from.vertex_offset, from.vertex_count);
    append(part.positions, whole.positions, used);
    append(part.normals, whole.normals, used);
    append(part.colours, whole.colours, used);
    append(part.texcoords, whole.texcoords, used);
    append(part.joints, whole.joints, used);
    append(part.morphs, whole.morphs, used);
    for (std::size_t t = 0; t < from.triangle_count; ++t) {
      const unsigned char* corner = &corners[from.triangle_offset + 3 * t];
      const auto index = [&](std::size_t k) { return static_cast<std::uint16_t>(meshlet.first_vertex + corner[k]); };
      part.triangles.push_back({index(0), index(1), index(2)});
    }
    set_bounds(meshlet, std::span(part.positions).subspan(meshlet.first_vertex), half_extent);
    part.meshlets.push_back(meshlet);
  }
  return parts;
}

}  // namespace zstrip::sim
