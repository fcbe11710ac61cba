// Chooses levels of detail. Runs once an instance and frame: twelve products of 64 bits and a binary search.
#include "zstrip/levels.hpp"

#include <algorithm>

namespace zstrip {
namespace {

/// The limits that a plan sets for a mesh.
struct MeshCounts {
  std::size_t triangles, vertices = 0, meshlets, largest = 0, longest = 0;
};

MeshCounts counts_of(const Mesh& mesh) {
  MeshCounts counts{.triangles = mesh.triangles.size(), .meshlets = mesh.meshlets.size()};
  if (mesh.meshlets.empty())
    return {counts.triangles, mesh.positions.size(), 1, mesh.positions.size(), counts.triangles};
  for (const Meshlet& meshlet : mesh.meshlets) {
    counts.vertices += meshlet.vertex_count;
    counts.largest = std::max<std::size_t>(counts.largest, meshlet.vertex_count);
    counts.longest = std::max<std::size_t>(counts.longest, meshlet.triangle_count);
  }
  return counts;
}

/// Returns the number of the mesh's edges; sets ascend by mesh.
std::size_t edges_of_mesh(const Scene& scene, std::uint16_t mesh) {
  const auto found = std::ranges::lower_bound(scene.edges, mesh, {}, &EdgeSet::mesh);
  return found != scene.edges.end() && found->mesh == mesh ? found->edges.size() : 0;
}

/// Returns the largest magnitude of texture coordinates along an axis.
std::int32_t reach_of(const Mesh& mesh, std::int16_t TexCoord::*axis) {
  std::int32_t reach = 0;
  for (const TexCoord& t : mesh.texcoords) reach = std::max<std::int32_t>(reach, t.*axis < 0 ? -(t.*axis) : t.*axis);
  return reach;
}

bool can_replace(const Scene& scene, const DetailLevel& level) {
  const Mesh &mesh = scene.meshes[level.mesh], &coarser = scene.meshes[level.coarser];
  const MeshCounts limit = counts_of(mesh), counts = counts_of(coarser);
  if (counts.triangles > limit.triangles || counts.vertices > limit.vertices || counts.meshlets > limit.meshlets ||
      counts.largest > limit.largest || counts.longest > limit.longest ||
      edges_of_mesh(scene, level.coarser) > edges_of_mesh(scene, level.mesh)) {
    return false;
  }
  for (const Mesh* each : {&mesh, &coarser}) {
    if (each->outline != 0 || each->skinning != nullptr) return false;
  }
  for (const auto axis : {&TexCoord::u, &TexCoord::v}) {
    if (reach_of(coarser, axis) > reach_of(mesh, axis)) return false;
  }
  return mesh.normals.empty() == coarser.normals.empty() && mesh.colours.empty() == coarser.colours.empty() &&
         mesh.texcoords.empty() == coarser.texcoords.empty() && mesh.texcoord_bits == coarser.texcoord_bits &&
         mesh.billboard == coarser.billboard && mesh.shadow == coarser.shadow;
}

std::span<const DetailLevel> levels_of(std::span<const DetailLevel> levels, std::uint16_t mesh) {
  return {std::ranges::lower_bound(levels, mesh, {}, &DetailLevel::mesh),
          std::ranges::upper_bound(levels, mesh, {}, &DetailLevel::mesh)};
}

/// Returns the distance of a mesh's centre from the camera along the viewing direction, 16.16.
std::int64_t distance_of(const Mesh& mesh, const Transform& transform, const Camera& camera) {
  const std::int32_t back[3] = {camera.back.x, camera.back.y, camera.back.z};
  const std::int32_t eye[3] = {camera.eye.x, camera.eye.y, camera.eye.z};
  std::int64_t along = 0;
  for (int row = 0; row < 3; ++row) {
    const Fixed(&m)[4] = transform.m[row];
    // 2^24 times 2^28, three of them: below 2^54; the place is below 2^39.
    const std::int64_t turned =
        std::int64_t{m[0]} * mesh.centre.x + std::int64_t{m[1]} * mesh.centre.y + std::int64_t{m[2]} * mesh.centre.z;
    const std::int64_t place = (turned >> kFixedBits) + m[3] - eye[row];
    along -= place * (back[row] >> 14);  // 1.16: the product is below 2^56
  }
  return along >> 16;
}

}  // namespace

Status validate(std::span<const DetailLevel> levels, const Scene& scene) {
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const Status wrong{.error = Error::mesh, .needed = static_cast<std::uint32_t>(i)};
    const DetailLevel& level = levels[i];
    if (level.mesh >= scene.meshes.size() || level.coarser >= scene.meshes.size() || level.distance < 0) return wrong;
    if (i != 0) {
      const DetailLevel& last = levels[i - 1];
      if (level.mesh < last.mesh || (level.mesh == last.mesh && level.distance <= last.distance)) return wrong;
      if (level.coarser <= last.coarser) return wrong;
    }
    if (i >= kMaxDetailLevels && levels[i - kMaxDetailLevels].mesh == level.mesh) return wrong;
    if (!can_replace(scene, level)) return wrong;
  }
  for (std::size_t i = 0; i < levels.size(); ++i) {
    if (levels_of(levels, levels[i].coarser).empty()) continue;
    return {.error = Error::mesh, .needed = static_cast<std::uint32_t>(i)};
  }
  return {};
}

void choose_levels(std::span<const DetailLevel> levels, const Scene& at_rest, const Camera& camera,
                   std::span<Instance> instances) {
  for (std::size_t i = 0; i < instances.size(); ++i) {
    const std::uint16_t own = at_rest.instances[i].mesh;
    instances[i].mesh = own;
    if (camera.projection == Projection::orthographic) continue;
    const std::span<const DetailLevel> its = levels_of(levels, own);
    if (its.empty()) continue;
    const std::int64_t distance = distance_of(at_rest.meshes[own], instances[i].transform, camera);
    for (const DetailLevel& level : its) {
      if (distance >= level.distance) instances[i].mesh = level.coarser;
    }
  }
}

}  // namespace zstrip
