// The one place where floating point becomes the renderer's fixed point.
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
#include "import/meshlets.hpp"
#include "import/quantised_skins.hpp"
#include "report/number.hpp"

namespace zstrip::sim {
namespace {

/// The common bounding box of the scene, and the way into its grid.
struct Grid {
  Units units;
  Vec3 centre{};       // 16.16
  Vec3 half_extent{};  // 16.16

  Position position(const std::array<float, 3>& from) const {
    const std::array<Fixed, 3> centres{centre.x, centre.y, centre.z};
    const auto coordinate = [&](std::size_t axis, Fixed half) {
      if (half == 0) return std::int16_t{0};
      const double scene = (double{from[axis]} - units.origin[axis]) * units.scale - from_fixed(centres[axis]);
      const double steps = std::round(scene * kFixedOne / half * 32768);  // 1.15 of the half extent
      return static_cast<std::int16_t>(std::clamp(steps, -32767.0, 32767.0));
    };
    return {coordinate(0, half_extent.x), coordinate(1, half_extent.y), coordinate(2, half_extent.z)};
  }
};

Grid fit_grid(const SourceModel& source) {
  std::array<double, 3> low{};
  std::array<double, 3> high{};
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
  for (const SourceMesh& mesh : source.meshes) {
    for (const SourceVertex& vertex : mesh.vertices) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        low[axis] = std::min(low[axis], double{vertex.position[axis]});
        high[axis] = std::max(high[axis], double{vertex.position[axis]});
      }
    }
  }
  Grid grid;
  double largest = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    grid.units.origin[axis] = (low[axis] + high[axis]) / 2;
    largest = std::max(largest, (high[axis] - low[axis]) / 2);
  }
  grid.units.scale = 1 / largest;
  // Rounded up, so that the outermost vertex stays within 32767 steps of 1/32768.
  const auto half_extent = [&](std::size_t axis) {
    const double half = (high[axis] - low[axis]) / 2 * grid.units.scale;
    return static_cast<Fixed>(std::ceil(half * 32768 / 32767 * kFixedOne));  // 16.16
  };
  grid.half_extent = {half_extent(0), half_extent(1), half_extent(2)};
  return grid;
}

/// Of a mesh that blends: the box of its own vertices, by whose distance the renderer sorts it.
Grid grid_of_own(const SourceMesh& mesh, const Grid& whole) {
  std::array<Fixed, 3> centres{}, halves{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const SourceVertex& vertex : mesh.vertices) {
      const double place = (double{vertex.position[axis]} - whole.units.origin[axis]) * whole.units.scale;
      low = std::min(low, place);
      high = std::max(high, place);
    }
    centres[axis] = to_fixed((low + high) / 2);
    // Rounded up, and a step more for the centre's rounding, so that the outermost vertex stays within 32767 steps.
    const double half = std::ceil((high - low) / 2 * 32768 / 32767 * kFixedOne);
    if (half > 0) halves[axis] = static_cast<Fixed>(half) + 1;  // 16.16
  }
  return {whole.units, {centres[0], centres[1], centres[2]}, {halves[0], halves[1], halves[2]}};
}

/// Of a mesh with a skin: all poses, with a margin, the same along all axes.
Grid grid_of_skin(const SourceModel& source, const SourceMesh& mesh, const Grid& whole) {
  constexpr double kMargin = 1.02;
  const SourceBox box = box_of_poses(source, mesh);
  Grid grid{whole.units, {}, {}};
  double largest = 0;
  std::array<double, 3> centre{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    centre[axis] = ((box.low[axis] + box.high[axis]) / 2 - whole.units.origin[axis]) * whole.units.scale;
    largest = std::max(largest, (box.high[axis] - box.low[axis]) / 2 * whole.units.scale);
  }
  const auto fixed = [](double value) { return to_fixed(std::clamp(value, -4094.0, 4094.0)); };
  grid.centre = {fixed(centre[0]), fixed(centre[1]), fixed(centre[2])};
  const Fixed half = fixed(largest * kMargin);
  grid.half_extent = {half, half, half};
  return grid;
}

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
    if (!source.has_skin) continue;
    VertexJoints& moved = data.joints.emplace_back();
    std::ranges::copy(vertex.joints, moved.joints);
    std::ranges::copy(vertex.weights, moved.weights);
  }
  return data;
}

bool is_textured(const SourceMesh& mesh, const SourceMaterial& material) {
  return mesh.has_texcoords && material.texture != kNoSourceTexture;
}

/// Of the source's textures those whose alpha something is masked or blended with.
std::vector<bool> find_used_alpha(const SourceModel& source) {
  std::vector<bool> used(source.textures.size());
  for (const SourceMesh& mesh : source.meshes) {
    const SourceMaterial& material = source.materials[mesh.material];
    if (!is_textured(mesh, material) || material.alpha_mode == AlphaMode::opaque) continue;
    if (!source.textures[material.texture].alpha.empty()) used[material.texture] = true;
  }
  return used;
}

/// Gives the material what few have, if the file's has any of it. False if the table is full.
bool set_finish(const SourceMaterial& from, Material& to, std::vector<Finish>& finishes) {
  Finish finish{.emissive = {from.emissive[0], from.emissive[1], from.emissive[2], 255}, .alpha_mode = from.alpha_mode};
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

Result<Model> quantise(const SourceModel& source, const std::vector<MeshTraits>& traits) {
  const Grid common = fit_grid(source);
  Model model;
  model.accuracy.size = 2 / common.units.scale;
  model.units = common.units;
  model.warnings = source.warnings;
  model.cameras = source.cameras;
  model.tree = source.nodes;
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
    if (!set_finish(from, material, model.finishes)) ++plain;
    if (is_textured(mesh, from)) {
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
    const Grid grid = mesh.has_skin                      ? grid_of_skin(source, mesh, common)
                      : blends && !mesh.vertices.empty() ? grid_of_own(mesh, common)
                                                         : common;
    const MeshData whole = to_mesh_data(mesh, traits[i].texcoord_bits, grid);
    note_vertices(model.accuracy, mesh, whole, grid.units, grid.centre, grid.half_extent);
    if (is_textured(mesh, from)) {
      note_texcoords(model.accuracy, mesh, whole, traits[i].texcoord_bits, source.textures[from.texture]);
    }
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
    }
  }
  if (const Result<Done> done = set_joints(source, model); !done) return done.failure();
  if (plain > 0) {
    model.warnings.push_back(
        fmt::format("{} drawn without emission and alpha: more than 255 kinds of these", counted(plain, "mesh")));
  }
  return model;
}

}  // namespace zstrip::sim
