// The meshes of a composed scene: each once for each size that it has in the scene.
#include "compose/composed_meshes.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "compose/composed_hull.hpp"
#include "import/meshlets.hpp"
#include "import/quantise.hpp"

namespace zstrip::sim {
namespace {

/// Scales the normals of a scaled surface: by the inverse, with unchanged length.
std::vector<Normal> scaled_normals(std::span<const Normal> normals, const Vector& scale) {
  std::vector<Normal> result;
  for (const Normal& n : normals) {
    const Vector v{n.x / scale[0], n.y / scale[1], n.z / scale[2]};
    const double length = std::hypot(v[0], v[1], v[2]);
    const auto component = [&](std::size_t axis) {
      return static_cast<std::int8_t>(length > 0 ? std::lround(127 * v[axis] / length) : 0);  // 1.7
    };
    result.push_back({component(0), component(1), component(2), 0});
  }
  return result;
}

}  // namespace

Vector ComposedMeshes::scale_of(const PlacedPart& placed) {
  if (placed.bends()) return {1, 1, 1};  // joints and morph targets move it in the units of its model
  const Affine& to_file = placed.part->to_file;
  Vector scale = placed.file->placement.scale;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double own = is_diagonal(to_file) ? std::abs(to_file.m[axis][axis]) : 1;
    scale[axis] *= scene_.units.scale * own;
  }
  // An existing mesh with nearly this size is used again.
  const auto known = first_scales_.try_emplace({placed.model_index, placed.part_index}, scale).first->second;
  const double ratio = scale[0] / known[0];
  const bool similar = placed.scaled_evenly() && ratio > 1.0 / 16 && ratio < 16 &&
                       std::abs(scale[1] / known[1] - ratio) < 1e-9 * ratio &&
                       std::abs(scale[2] / known[2] - ratio) < 1e-9 * ratio;
  return similar ? known : scale;
}

std::uint16_t ComposedMeshes::index_of(const PlacedPart& placed, const Vector& scale) {
  const std::optional<FileOutline>& outline = placed.file->outline;
  const Colour colour = outline ? outline->colour : Colour{};
  const auto width = static_cast<std::uint16_t>(outline ? std::lround(16 * outline->width) : 0);
  const Key key{
      placed.model_index, placed.part_index, scale, placed.file->billboard, width, {colour.r, colour.g, colour.b},
      placed.file->shadow};
  if (const auto at = known_.find(key); at != known_.end()) return at->second;
  Mesh mesh = placed.part->mesh;
  mesh.billboard = placed.file->billboard;
  mesh.shadow = placed.file->shadow;
  std::size_t axis = 0;
  for (Fixed Vec3::*const member : {&Vec3::x, &Vec3::y, &Vec3::z}) {
    mesh.centre.*member = to_fixed(from_fixed(mesh.centre.*member) * scale[axis]);
    mesh.half_extent.*member = to_fixed(from_fixed(mesh.half_extent.*member) * scale[axis]);
    ++axis;
  }
  if (!placed.scaled_evenly()) {
    MeshData& own = scene_.scaled.emplace_back();
    own.normals = scaled_normals(mesh.normals, placed.file->placement.scale);
    own.meshlets.assign(mesh.meshlets.begin(), mesh.meshlets.end());
    for (Meshlet& meshlet : own.meshlets) {
      set_bounds(meshlet, mesh.positions.subspan(meshlet.first_vertex, meshlet.vertex_count), mesh.half_extent);
    }
    mesh.normals = own.normals;
    mesh.meshlets = own.meshlets;
  }
  if (const std::optional<std::uint16_t> hull = outline ? hull_of(placed, mesh, scale) : std::nullopt) {
    const Outline own{.colour = colour, .width = width, .hull = *hull};
    const auto same = [&own](const Outline& other) {
      return other.colour == own.colour && other.width == own.width && other.hull == own.hull;
    };
    const auto at = std::ranges::find_if(scene_.outlines, same);
    mesh.outline = static_cast<std::uint8_t>(at - scene_.outlines.begin() + 1);
    if (at == scene_.outlines.end()) scene_.outlines.push_back(own);
  }
  const auto index = static_cast<std::uint16_t>(scene_.meshes.size());
  scene_.meshes.push_back(mesh);
  if (placed.bends() && placed.part->skin != nullptr) {
    ModelSkin& skin = scene_.bent.skins.emplace_back(*placed.part->skin);
    skin.mesh = index;
    skin.bind.shadow = mesh.shadow;
  }
  if (placed.bends() && placed.part->morph != nullptr) {
    ModelMorph& morph = scene_.bent.morphs.emplace_back(*placed.part->morph);
    morph.mesh = index;
    morph.base.shadow = mesh.shadow;
  }
  known_[key] = index;
  return index;
}

std::optional<std::uint16_t> ComposedMeshes::hull_of(const PlacedPart& placed, const Mesh& mesh, const Vector& scale) {
  if (is_own_hull(mesh)) return kOwnMesh;
  const auto [at, is_new] = hulls_.try_emplace({placed.model_index, placed.part_index, scale, placed.file->billboard});
  std::optional<std::uint16_t>& hull_index = at->second;
  if (!is_new) return hull_index;
  std::vector<MeshData> parts = sim::hull_of(mesh);
  if (parts.empty()) return hull_index;
  if (parts.size() > 1) return hull_index = kNoHull;
  const MeshData& own = scene_.hulls.emplace_back(std::move(parts.front()));
  Mesh hull = mesh;
  hull.positions = own.positions;
  hull.normals = own.normals;
  hull.colours = {};
  hull.texcoords = {};
  hull.triangles = own.triangles;
  hull.meshlets = own.meshlets;
  hull_index = static_cast<std::uint16_t>(scene_.meshes.size());
  scene_.meshes.push_back(hull);
  return hull_index;
}

void leave_out_unread_normals(ComposedScene& scene) {
  std::vector<bool> is_read(scene.meshes.size(), true);
  for (const Instance& instance : scene.instances) {
    is_read[instance.mesh] = scene.meshes[instance.mesh].outline > 0;
  }
  const auto reads_normals = [&scene](std::uint16_t material) {
    const Material& of = scene.materials[material];
    return of.lit || (of.finish < scene.finishes.size() && is_environment(scene.finishes[of.finish].filter));
  };
  for (const Instance& instance : scene.instances) {
    if (reads_normals(instance.material)) is_read[instance.mesh] = true;
  }
  for (const LineSet& set : scene.lines) {
    if (reads_normals(set.material)) is_read[set.mesh] = true;
  }
  for (const Outline& outline : scene.outlines) {
    if (outline.hull < is_read.size()) is_read[outline.hull] = true;
  }
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    if (!is_read[i]) scene.meshes[i].normals = {};
  }
  for (ModelSkin& skin : scene.bent.skins) {
    if (!is_read[skin.mesh]) skin.bind.normals = {};
  }
  for (ModelMorph& morph : scene.bent.morphs) {
    if (is_read[morph.mesh]) continue;
    morph.base.normals = {};
    for (MorphTarget& target : morph.targets) target.normals = {};
  }
}

}  // namespace zstrip::sim
