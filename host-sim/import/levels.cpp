// Finds coarser meshes for a scene's levels of detail. They are made of the meshes as they were quantised, so that any
// scene can have levels, and all vertices keep their positions.
#include "import/levels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "import/meshlets.hpp"
#include "import/quantise.hpp"
#include "import/reduction.hpp"
#include "import/surface.hpp"

namespace zstrip::sim {
namespace {

constexpr int kMaxLevels = 3;
constexpr double kLevelShare = 0.25;    // of the triangles of the level before
constexpr double kMaxLevelShare = 0.6;  // a level with more takes more flash than it saves time
constexpr int kStepsOfHalf = 32768;     // of a half extent
constexpr float kNormalSteps = 127;

/// Converts one axis of a mesh's positions to lengths and back. Equal places of meshes with one box get equal floats.
struct Axis {
  double centre, half;
  float length(std::int16_t steps) const { return static_cast<float>(centre + half * steps / kStepsOfHalf) + 0.0F; }
  std::int16_t steps(float at) const {
    return static_cast<std::int16_t>(half > 0 ? std::lround((double{at} - centre) * kStepsOfHalf / half) : 0);
  }
};

std::array<Axis, 3> axes_of(const Mesh& mesh) {
  return {Axis{from_fixed(mesh.centre.x), from_fixed(mesh.half_extent.x)},
          Axis{from_fixed(mesh.centre.y), from_fixed(mesh.half_extent.y)},
          Axis{from_fixed(mesh.centre.z), from_fixed(mesh.half_extent.z)}};
}

SourceMesh to_source(const Mesh& mesh) {
  const std::array<Axis, 3> axes = axes_of(mesh);
  SourceMesh source;
  source.has_colours = !mesh.colours.empty();
  source.has_texcoords = !mesh.texcoords.empty();
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Position& p = mesh.positions[i];
    SourceVertex vertex;
    vertex.position = {axes[0].length(p.x), axes[1].length(p.y), axes[2].length(p.z)};
    if (!mesh.normals.empty()) {
      const Normal& n = mesh.normals[i];
      vertex.normal = {static_cast<float>(n.x) / kNormalSteps, static_cast<float>(n.y) / kNormalSteps,
                       static_cast<float>(n.z) / kNormalSteps};
    }
    if (source.has_colours) {
      const Colour& c = mesh.colours[i];
      vertex.colour = {c.r, c.g, c.b, c.a};
    }
    if (source.has_texcoords) {
      const auto coordinate = [&mesh](std::int16_t c) {
        return std::ldexp(static_cast<float>(c), -mesh.texcoord_bits);
      };
      vertex.texcoord = {coordinate(mesh.texcoords[i].u), coordinate(mesh.texcoords[i].v)};
    }
    source.vertices.push_back(vertex);
  }
  for (const Triangle& t : mesh.triangles) source.indices.insert(source.indices.end(), {t.a, t.b, t.c});
  weld(source);
  return source;
}

/// Returns the vertices of a simplified mesh in the steps of `like`.
MeshData to_data(SourceMesh& source, const Mesh& like) {
  const std::array<Axis, 3> axes = axes_of(like);
  if (like.normals.empty()) {
    // The simplifier gave each vertex without a normal that of its face.
    for (SourceVertex& vertex : source.vertices) vertex.normal = {};
    weld(source);
  }
  MeshData data;
  for (const SourceVertex& vertex : source.vertices) {
    data.positions.push_back(
        {axes[0].steps(vertex.position[0]), axes[1].steps(vertex.position[1]), axes[2].steps(vertex.position[2])});
    if (!like.normals.empty()) {
      const auto component = [](float c) { return static_cast<std::int8_t>(std::lround(c * kNormalSteps)); };
      data.normals.push_back(
          {component(vertex.normal[0]), component(vertex.normal[1]), component(vertex.normal[2]), 0});
    }
    if (source.has_colours) {
      const std::array<std::uint8_t, 4>& c = vertex.colour;
      data.colours.push_back({c[0], c[1], c[2], c[3]});
    }
    if (source.has_texcoords) {
      const auto coordinate = [&like](float c) {
        return static_cast<std::int16_t>(std::lround(std::ldexp(c, like.texcoord_bits)));
      };
      data.texcoords.push_back({coordinate(vertex.texcoord[0]), coordinate(vertex.texcoord[1])});
    }
  }
  return data;
}

/// Returns the picture of a texture without a palette; others are not known, so that vertices stay where coordinates
/// turn.
std::optional<RgbImage> picture_of_texture(const Texture& texture) {
  if (has_palette(texture.format)) return std::nullopt;
  RgbImage image;
  image.width = 1U << texture.log2_width;
  image.height = 1U << texture.log2_height;
  for (const std::uint16_t word : texture.texels.first(std::size_t{image.width} * image.height)) {
    const std::uint32_t red = word >> 11, green = word >> 5 & 63, blue = word & 31;
    for (const std::uint32_t channel : {red * 255 / 31, green * 255 / 63, blue * 255 / 31}) {
      image.rgb.push_back(static_cast<std::uint8_t>(channel));
    }
  }
  return image;
}

/// Gives each mesh its texture, by which the simplifier judges whether a change of its coordinates is seen.
void add_textures(const Scene& scene, std::span<const std::uint16_t> meshes, SourceModel& model) {
  std::map<std::uint16_t, std::uint32_t> known;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    SourceMaterial& material = model.materials.emplace_back();
    model.meshes[i].material = static_cast<std::uint32_t>(i);
    const auto drawn = std::ranges::find(scene.instances, meshes[i], &Instance::mesh);
    const std::uint16_t texture = scene.materials[drawn->material].texture;
    if (!model.meshes[i].has_texcoords || texture == kNoTexture) continue;
    if (!known.contains(texture)) {
      std::optional<RgbImage> image = picture_of_texture(scene.textures[texture]);
      if (!image) continue;
      known[texture] = static_cast<std::uint32_t>(model.textures.size());
      model.textures.push_back(std::move(*image));
    }
    material.texture = known[texture];
  }
}

/// Returns the limits of a coarser mesh, whose meshlets may not be larger than those of `mesh`.
MeshletLimits limits_of(const Mesh& mesh) {
  if (mesh.meshlets.empty()) return {};
  std::size_t vertices = 3, triangles = 4;
  for (const Meshlet& meshlet : mesh.meshlets) {
    vertices = std::max<std::size_t>(vertices, meshlet.vertex_count);
    triangles = std::max<std::size_t>(triangles, meshlet.triangle_count);
  }
  return {std::min(vertices, kMeshletVertices), std::min(triangles, kMeshletTriangles) / 4 * 4};
}

bool can_have_levels(const Mesh& mesh) {
  return mesh.outline == 0 && mesh.skinning == nullptr &&
         static_cast<double>(mesh.triangles.size()) * kLevelShare >= double{kMinLevelTriangles};
}

}  // namespace

SceneLevels find_levels(const Scene& scene, std::span<const std::size_t> left_out) {
  std::set<std::uint16_t> drawn;
  for (const Instance& instance : scene.instances) drawn.insert(instance.mesh);
  for (const std::size_t mesh : left_out) drawn.erase(static_cast<std::uint16_t>(mesh));
  std::vector<std::uint16_t> meshes;  // with triangles: the others' borders stay, too
  SourceModel whole;
  for (const std::uint16_t index : drawn) {
    const Mesh& mesh = scene.meshes[index];
    if (mesh.triangles.empty()) continue;
    meshes.push_back(index);
    whole.meshes.push_back(to_source(mesh));
  }
  add_textures(scene, meshes, whole);
  SceneLevels found;
  std::vector<std::size_t> triangles;  // of each mesh's coarsest level
  for (const std::uint16_t mesh : meshes) triangles.push_back(scene.meshes[mesh].triangles.size());
  double share = 1;
  for (int level = 0; level < kMaxLevels; ++level) {
    share *= kLevelShare;
    SourceModel coarser = whole;
    const std::vector<ReducedMesh> reduced = reduce_each(coarser, share);
    for (std::size_t i = 0; i < reduced.size(); ++i) {
      const Mesh& own = scene.meshes[meshes[i]];
      const auto count = static_cast<std::size_t>(reduced[i].triangles);
      if (!can_have_levels(own) || count < kMinLevelTriangles ||
          static_cast<double>(count) > kMaxLevelShare * static_cast<double>(triangles[i])) {
        continue;
      }
      const MeshData vertices = to_data(coarser.meshes[i], own);
      std::vector<MeshData> parts =
          split_into_meshlets(vertices, coarser.meshes[i].indices, own.half_extent, limits_of(own));
      if (parts.size() != 1) continue;
      if (own.meshlets.empty()) parts.front().meshlets.clear();
      triangles[i] = count;
      found.data.push_back(std::move(parts.front()));
      found.meshes.push_back({meshes[i], with_data(own, found.data.back()), reduced[i].error});
    }
  }
  std::ranges::stable_sort(found.meshes, {}, &CoarserMesh::mesh);
  return found;
}

}  // namespace zstrip::sim
