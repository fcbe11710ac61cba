// Moves meshlets of skins while they are drawn; only renderers with effect::skins link it.
#include <cstdint>

#include "zstrip/effects/skins/move_meshlet.hpp"
#include "zstrip/effects/skins/skin_stage.hpp"
#include "zstrip/scene/move_vertices.hpp"

namespace zstrip::detail::skins {
namespace {

bool has_sizes_of(const Skinning& skinning, const Mesh& mesh) {
  if (skinning.skin == nullptr || skinning.skin->vertices.size() != mesh.positions.size() ||
      skinning.matrices.size() != skinning.skin->joints.size()) {
    return false;
  }
  std::size_t largest = 0;
  for (std::uint32_t i = 0; i < meshlet_count(mesh); ++i) {
    const std::size_t vertices = meshlet_range(mesh, i).vertex_count;
    if (vertices > largest) largest = vertices;
  }
  return skinning.positions.size() >= largest && (mesh.normals.empty() || skinning.normals.size() >= largest);
}

/// Returns an array that can be indexed like the whole mesh: it begins at the address that vertex 0 would have.
template <class Vertex>
std::span<const Vertex> as_if_whole(std::span<Vertex> part, std::uint32_t first_vertex, std::size_t whole) {
  const std::uintptr_t address = reinterpret_cast<std::uintptr_t>(part.data()) - first_vertex * sizeof(Vertex);
  // Uses an integer, because a pointer before the array would be undefined. NOLINTNEXTLINE(performance-no-int-to-ptr)
  return {reinterpret_cast<const Vertex*>(address), whole};
}

/// Returns the skin if begin_meshlet has returned `mesh` for one; else null.
const Skinning* moving(const Mesh& mesh) {
  return mesh.skinning != nullptr && &mesh == &mesh.skinning->moved ? mesh.skinning : nullptr;
}

}  // namespace

Status check(const Scene& scene) {
  const auto is_skin = [&scene](std::uint32_t mesh) { return scene.meshes[mesh].skinning != nullptr; };
  const auto wrong = [](std::uint32_t mesh) { return Status{.error = Error::skin, .needed = mesh}; };
  for (std::uint32_t i = 0; i < scene.meshes.size(); ++i) {
    if (is_skin(i) && !has_sizes_of(*scene.meshes[i].skinning, scene.meshes[i])) return wrong(i);
  }
  for (const LineSet& lines : scene.lines) {
    if (is_skin(lines.mesh)) return wrong(lines.mesh);
  }
  for (const EdgeSet& edges : scene.edges) {
    if (edges.mesh < scene.meshes.size() && is_skin(edges.mesh)) return wrong(edges.mesh);
  }
  for (const CsgOperand& operand : scene.csg) {
    if (const std::uint32_t mesh = scene.instances[operand.instance].mesh; is_skin(mesh)) return wrong(mesh);
  }
  return {};
}

const Mesh& begin_meshlet(const Mesh& mesh, std::uint32_t first_vertex) {
  if (mesh.skinning == nullptr || mesh.skinning->fraction_bits == 0) return mesh;
  Skinning& skinning = *mesh.skinning;
  skinning.moved = mesh;
  skinning.moved.positions = as_if_whole(skinning.positions, first_vertex, mesh.positions.size());
  if (!mesh.normals.empty()) {
    skinning.moved.normals = as_if_whole(skinning.normals, first_vertex, mesh.normals.size());
  }
  return skinning.moved;
}

void move_positions(const Mesh& mesh, const MeshletRange& range) {
  const Skinning* const skinning = moving(mesh);
  if (skinning == nullptr) return;
  const Skin& skin = *skinning->skin;
  detail::move_positions(skin.mesh->positions.subspan(range.first_vertex, range.vertex_count),
                         skin.vertices.subspan(range.first_vertex, range.vertex_count),
                         {skinning->matrices.data(), skinning->fraction_bits}, skinning->positions);
}

void move_normals(const Mesh& mesh, const MeshletRange& range) {
  const Skinning* const skinning = moving(mesh);
  if (skinning == nullptr || mesh.normals.empty()) return;
  const Skin& skin = *skinning->skin;
  const auto place = static_cast<std::size_t>(&mesh.normals[range.first_vertex] - skinning->normals.data());
  detail::move_normals(skin.mesh->normals.subspan(range.first_vertex, range.vertex_count),
                       skin.vertices.subspan(range.first_vertex, range.vertex_count),
                       {skinning->matrices.data(), skinning->fraction_bits},
                       skinning->normals.subspan(place, range.vertex_count));
}

}  // namespace zstrip::detail::skins
