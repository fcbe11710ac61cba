// Samples the texture at a grid of places of each triangle; each sample counts for the corners near it.
#include "import/folded_textures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

#include "import/screen_channel.hpp"
#include "import/surface.hpp"
#include "motion/affine.hpp"

namespace zstrip::sim {
namespace {

constexpr int kMaxRows = 16;  // of places along a triangle's side

/// The linear light of the texels around a vertex, and the sum of their weights.
struct Light {
  std::array<double, 3> channels{};
  double weight = 0;
};

class Folding {
 public:
  Folding(const RgbImage& texture, const std::array<TextureWrap, 2>& wrap) : texture_(texture), wrap_(wrap) {
    for (std::size_t i = 0; i < linear_.size(); ++i) linear_[i] = from_screen_channel(static_cast<std::uint8_t>(i));
  }

  void add(const SourceMesh& mesh, std::size_t first, std::vector<Light>& lights) const {
    std::array<const SourceVertex*, 3> corners{};
    for (std::size_t i = 0; i < 3; ++i) corners[i] = &mesh.vertices[mesh.indices[first + i]];
    const int rows = rows_of(corners);
    const double area = area_of(corners);
    for (int i = 0; i < rows; ++i) {
      for (int j = 0; i + j < rows; ++j) {
        const double b = (i + 1.0 / 3) / rows, c = (j + 1.0 / 3) / rows;
        const std::array<double, 3> share{1 - b - c, b, c};
        const std::uint8_t* const texel = texel_at(corners, share);
        for (std::size_t corner = 0; corner < 3; ++corner) {
          Light& light = lights[mesh.indices[first + corner]];
          const double weight = area * share[corner] * share[corner] / rows / rows;
          light.weight += weight;
          for (std::size_t k = 0; k < 3; ++k) light.channels[k] += weight * linear_[texel[k]];
        }
      }
    }
  }

 private:
  using Corners = std::array<const SourceVertex*, 3>;

  /// A row a texel, up to kMaxRows.
  int rows_of(const Corners& corners) const {
    double longest = 1;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const auto [low, high] =
          std::minmax({corners[0]->texcoord[axis], corners[1]->texcoord[axis], corners[2]->texcoord[axis]});
      longest = std::max(longest, double{high - low} * (axis == 0 ? texture_.width : texture_.height));
    }
    return std::isfinite(longest) ? static_cast<int>(std::min(std::ceil(longest), double{kMaxRows})) : 1;
  }

  /// Returns twice the triangle's area, not quite 0, so that a vertex of thin triangles alone has a colour, too.
  static double area_of(const Corners& corners) {
    const auto side = [&](std::size_t corner) {
      Vector edge{};
      for (std::size_t i = 0; i < 3; ++i) {
        edge[i] = double{corners[corner]->position[i]} - double{corners[0]->position[i]};
      }
      return edge;
    };
    const Vector normal = vector_product(side(1), side(2));
    return std::sqrt(scalar_product(normal, normal)) + 1e-30;
  }

  const std::uint8_t* texel_at(const Corners& corners, const std::array<double, 3>& share) const {
    const auto at = [&](std::size_t axis, std::uint32_t side) {
      double place = 0;
      for (std::size_t i = 0; i < 3; ++i) place += share[i] * double{corners[i]->texcoord[axis]};
      if (!std::isfinite(place)) return std::uint32_t{0};
      if (wrap_[axis] == TextureWrap::clamp) place = std::clamp(place, 0.0, 1.0);
      double within = place - std::floor(place);
      if (wrap_[axis] == TextureWrap::mirror && std::fmod(std::abs(std::floor(place)), 2) == 1) within = 1 - within;
      if (wrap_[axis] == TextureWrap::clamp && place == 1) within = 1;
      return std::min(static_cast<std::uint32_t>(within * side), side - 1);
    };
    return texture_.pixel(at(0, texture_.width), at(1, texture_.height));
  }

  const RgbImage& texture_;
  std::array<TextureWrap, 2> wrap_;
  std::array<double, 256> linear_{};
};

bool can_fold(const SourceModel& model, const SourceMesh& mesh) {
  const SourceMaterial& material = model.materials[mesh.material];
  if (material.texture == kNoSourceTexture || !mesh.has_texcoords || material.is_mirror) return false;
  return material.alpha_mode == AlphaMode::opaque ||
         (material.alpha_mode == AlphaMode::blend && model.textures[material.texture].alpha.empty());
}

}  // namespace

Shrunk fold_textures(SourceModel& model) {
  std::set<std::uint32_t> folded;
  std::vector<bool> is_folded(model.materials.size());
  for (SourceMesh& mesh : model.meshes) {
    if (!can_fold(model, mesh)) continue;
    weld(mesh);
    const SourceMaterial& material = model.materials[mesh.material];
    const Folding folding(model.textures[material.texture], material.wrap);
    std::vector<Light> lights(mesh.vertices.size());
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) folding.add(mesh, i, lights);
    for (std::size_t i = 0; i < lights.size(); ++i) {
      if (lights[i].weight <= 0) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        const unsigned texel = to_screen_channel(lights[i].channels[k] / lights[i].weight, true);
        // An unlit material shows its texels alone.
        const unsigned own = material.lit && mesh.has_colours ? mesh.vertices[i].colour[k] : 255U;
        mesh.vertices[i].colour[k] = static_cast<std::uint8_t>((texel * own + 127) / 255);
      }
      mesh.vertices[i].texcoord = {};
    }
    mesh.has_colours = true;
    mesh.has_texcoords = false;
    folded.insert(material.texture);
    is_folded[mesh.material] = true;
  }
  for (std::size_t i = 0; i < is_folded.size(); ++i) {
    if (is_folded[i]) model.materials[i].texture = kNoSourceTexture;
  }
  Shrunk record;
  for (const std::uint32_t texture : folded) {
    // Others may still show it.
    if (std::ranges::find(model.materials, texture, &SourceMaterial::texture) != model.materials.end()) continue;
    RgbImage& image = model.textures[texture];
    ++record.textures;
    record.texels_before += std::uint64_t{image.width} * image.height;
    image = {1, 1, {255, 255, 255}};
  }
  return record;
}

}  // namespace zstrip::sim
