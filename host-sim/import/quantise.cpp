// The only place where floating point becomes the renderer's fixed point.
#include "import/quantise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "image/palette.hpp"
#include "image/resample.hpp"
#include "import/accuracy.hpp"
#include "import/fixed_lights.hpp"
#include "import/grid.hpp"
#include "import/lines.hpp"
#include "import/meshlets.hpp"
#include "import/outlying.hpp"
#include "import/quantised_morphs.hpp"
#include "import/quantised_skins.hpp"
#include "text/number.hpp"
#include "text/step_report.hpp"

namespace zstrip::sim {
namespace {

Normal to_normal(const std::array<float, 3>& from) {
  const auto component = [](float value) {
    return static_cast<std::int8_t>(std::lround(127 * std::clamp(value, -1.0F, 1.0F)));  // 1.7
  };
  return {component(from[0]), component(from[1]), component(from[2]), 0};
}

TexCoord to_texcoord(const std::array<float, 2>& from, int bits) {
  const auto component = [bits](float value) {
    const double scaled = std::round(std::ldexp(double{value}, bits));
    return static_cast<std::int16_t>(std::clamp(scaled, -32767.0, 32767.0));
  };
  return {component(from[0]), component(from[1])};
}

MeshData to_mesh_data(const SourceMesh& source, int texcoord_bits, const Grid& grid) {
  MeshData data;
  for (const SourceVertex& vertex : source.vertices) {
    data.positions.push_back(grid.position(vertex.position));
    data.normals.push_back(to_normal(vertex.normal));
    if (source.has_colours) data.colours.push_back({vertex.colour[0], vertex.colour[1], vertex.colour[2], 255});
    if (source.has_texcoords) data.texcoords.push_back(to_texcoord(vertex.texcoord, texcoord_bits));
    if (source.has_morphs) data.morphs.push_back(vertex.morph);
    if (!source.has_skin) continue;
    VertexJoints moved;
    std::ranges::copy(vertex.joints, moved.joints);
    std::ranges::copy(vertex.weights, moved.weights);
    data.joints.push_back(moved);
  }
  return data;
}

bool is_textured(const SourceMesh& mesh, const SourceMaterial& material) {
  return (mesh.has_texcoords || material.is_mirror) && material.texture != kNoSourceTexture;
}

/// Returns true for the source's textures whose alpha a material masks or blends with.
std::vector<bool> find_used_alpha(const SourceModel& source) {
  std::vector<bool> used(source.textures.size());
  for (const SourceMesh& mesh : source.meshes) {
    const SourceMaterial& material = source.materials[mesh.material];
    if (!is_textured(mesh, material) || material.alpha_mode == AlphaMode::opaque) continue;
    if (!source.textures[material.texture].alpha.empty()) used[material.texture] = true;
  }
  return used;
}

/// Sets the material's finish if the file's material needs one. Returns false if the table is full.
bool set_finish(const SourceMaterial& from, Material& to, std::vector<Finish>& finishes) {
  Finish finish{.emissive = {from.emissive[0], from.emissive[1], from.emissive[2], 255}, .alpha_mode = from.alpha_mode};
  if (from.specular != std::array<std::uint8_t, 3>{}) {
    finish.specular = {from.specular[0], from.specular[1], from.specular[2], 255};
    finish.shininess = from.shininess;
  }
  if (from.is_mirror) finish.filter = TextureFilter::environment_nearest;
  if (from.alpha_mode == AlphaMode::mask) finish.alpha_cutoff = from.alpha_cutoff;
  if (finish == Finish{}) return true;
  const auto known = std::find(finishes.begin(), finishes.end(), finish);
  const auto index = known - finishes.begin();
  if (index >= kNoFinish) return false;
  if (known == finishes.end()) finishes.push_back(finish);
  to.finish = static_cast<std::uint8_t>(index);
  return true;
}

}  // namespace

std::vector<std::uint16_t> to_rgb565(const RgbImage& image) {
  std::vector<std::uint16_t> texels;
  texels.reserve(image.rgb.size() / 3);
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
    const auto channel = [&](std::size_t offset, unsigned levels) {
      return (image.rgb[i + offset] * levels + 127U) / 255U;  // to nearest
    };
    texels.push_back(static_cast<std::uint16_t>(channel(0, 31) << 11 | channel(1, 63) << 5 | channel(2, 31)));
  }
  return texels;
}

void append_alpha(const RgbImage& image, std::vector<std::uint16_t>& words) { append_packed(image.alpha, 8, words); }

Fixed to_fixed(double value) { return static_cast<Fixed>(std::llround(value * kFixedOne)); }

Affine to_affine(const Transform& map) {
  Affine affine;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 4; ++column) affine.m[row][column] = from_fixed(map.m[row][column]);
  }
  return affine;
}

Result<Model> quantise(const SourceModel& source, const std::vector<MeshTraits>& traits) {
  const Grid common = fit_grid(source);
  Model model;
  model.accuracy.size = 2 / common.units.scale;
  model.units = common.units;
  model.outlying = outlying_of(source);
  model.warnings = source.warnings;
  model.cameras = source.cameras;
  model.tree = source.nodes;
  model.weights.resize(source.weights.size());
  set_lights(source.lights, common.units, model);
  const std::vector<bool> used_alpha = find_used_alpha(source);
  std::uint64_t plain = 0;

  std::map<std::uint32_t, std::uint16_t> textures;  // only those in use, in order of use
  for (std::size_t i = 0; i < source.meshes.size(); ++i) {
    const SourceMesh& mesh = source.meshes[i];
    const SourceMaterial& from = source.materials[mesh.material];
    Material material{.colour = {from.colour[0], from.colour[1], from.colour[2], from.alpha},
                      .lit = from.lit,
                      .smooth = from.smooth,
                      .double_sided = traits[i].double_sided};
    const bool finished = set_finish(from, material, model.finishes);
    if (!finished) ++plain;
    if (is_textured(mesh, from) && (finished || !from.is_mirror)) {
      const auto [at, is_new] = textures.try_emplace(from.texture, static_cast<std::uint16_t>(model.textures.size()));
      if (is_new) {
        const RgbImage& image = source.textures[from.texture];
        model.texels.push_back(to_rgb565(image));
        note_texels(model.accuracy, image, model.texels.back());
        if (used_alpha[from.texture]) append_alpha(image, model.texels.back());
        model.textures.push_back({model.texels.back(), static_cast<std::uint8_t>(log2_of(image.width)),
                                  static_cast<std::uint8_t>(log2_of(image.height)),
                                  used_alpha[from.texture] ? TextureFormat::rgb565_alpha : TextureFormat::rgb565});
      }
      material.texture = at->second;
    }
    const std::size_t material_index = model.materials.size();
    model.materials.push_back(material);

    model.material_names.push_back(from.name);

    const bool blends = from.alpha_mode == AlphaMode::blend;
    const Grid grid = mesh.has_skin || mesh.has_morphs   ? grid_of_moved(source, mesh, common)
                      : blends && !mesh.vertices.empty() ? grid_of_own(mesh, common)
                                                         : common;
    tell_step("quantising the vertices");
    const MeshData whole = to_mesh_data(mesh, traits[i].texcoord_bits, grid);
    note_vertices(model.accuracy, mesh, whole, grid);
    if (is_textured(mesh, from) && !from.is_mirror) {
      note_texcoords(model.accuracy, mesh, whole, traits[i].texcoord_bits, source.textures[from.texture]);
    }
    tell_step("cutting the model into meshlets");
    for (MeshData& part : split_into_meshlets(whole, mesh.indices, grid.half_extent)) {
      const MeshData& data = model.mesh_data.emplace_back(std::move(part));
      if (model.meshes.size() >= kMaxMeshes || material_index >= kMaxMeshes) {
        return Failure{ExitStatus::input, kTooManyMeshes};
      }
      model.instances.push_back({.mesh = static_cast<std::uint16_t>(model.meshes.size()),
                                 .material = static_cast<std::uint16_t>(material_index)});
      model.nodes.push_back(mesh.node);
      if (mesh.has_skin) model.skins.push_back({model.meshes.size(), {}, data.joints});
      model.meshes.push_back({.positions = data.positions,
                              .normals = data.normals,
                              .colours = data.colours,
                              .texcoords = data.texcoords,
                              .triangles = data.triangles,
                              .meshlets = data.meshlets,
                              .centre = grid.centre,
                              .half_extent = grid.half_extent,
                              .texcoord_bits = static_cast<std::uint8_t>(traits[i].texcoord_bits)});
      if (mesh.has_skin) model.skins.back().bind = model.meshes.back();
      if (mesh.has_morphs) add_morph(source, grid, data.morphs, model);
    }
  }
  if (const Result<Done> done = add_lines(source, common, model); !done) return done.failure();
  if (const Result<Done> done = set_joints(source, model); !done) return done.failure();
  if (plain > 0) {
    model.warnings.push_back(
        fmt::format("{} drawn without emission and alpha: more than 255 kinds of these", counted(plain, "mesh")));
  }
  return model;
}

}  // namespace zstrip::sim
