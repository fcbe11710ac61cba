// Reads the alpha of materials that Assimp has read: factors, and maps that become the alpha of a texture.
#include "import/assimp/opacity.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <span>
#include <vector>

#include "import/area_filter.hpp"

namespace zstrip::sim {
namespace {

constexpr std::uint8_t kOpaque = 255;

bool is_invisible(const SourceMaterial& material, const SourceModel& model) {
  if (material.alpha_mode == AlphaMode::opaque) return false;
  if (material.alpha == 0) return true;
  if (material.texture == kNoSourceTexture) return false;
  const std::vector<std::uint8_t>& alpha = model.textures[material.texture].alpha;
  return !alpha.empty() && std::ranges::all_of(alpha, [](std::uint8_t value) { return value == 0; });
}

}  // namespace

double alpha_of(const aiMaterial& material) {
  float value = 1;
  if (material.Get(AI_MATKEY_OPACITY, value) == AI_SUCCESS) {
    return std::isfinite(value) ? std::clamp(double{value}, 0.0, 1.0) : 1;
  }
  // FBX without Opacity, whose TransparentColor is black or absent. Some programs write a factor of 1 for opaque
  // materials, so that only factors between 0 and 1 say something.
  const bool found = material.Get(AI_MATKEY_TRANSPARENCYFACTOR, value) == AI_SUCCESS;
  return found && value > 0 && value < 1 ? 1 - double{value} : 1;
}

AlphaMode alpha_mode_of(const RgbImage& image) {
  const std::vector<std::uint8_t>& alpha = image.alpha;
  if (std::ranges::all_of(alpha, [](std::uint8_t value) { return value == kOpaque; })) return AlphaMode::opaque;
  const bool two_values = std::ranges::all_of(alpha, [](std::uint8_t value) { return value == 0 || value == kOpaque; });
  return two_values ? AlphaMode::mask : AlphaMode::blend;
}

RgbImage white_with_alpha_of(const RgbImage& map, bool inverted) {
  RgbImage white{map.width, map.height, std::vector<std::uint8_t>(map.rgb.size(), 255), map.alpha};
  if (map.alpha.empty()) {
    white.alpha.reserve(map.rgb.size() / 3);
    for (std::size_t i = 0; i < map.rgb.size(); i += 3) {
      const unsigned luminance = (2126U * map.rgb[i] + 7152U * map.rgb[i + 1] + 722U * map.rgb[i + 2] + 5000U) / 10000U;
      white.alpha.push_back(static_cast<std::uint8_t>(luminance));
    }
  }
  if (inverted) {
    std::ranges::transform(white.alpha, white.alpha.begin(),
                           [](std::uint8_t value) { return static_cast<std::uint8_t>(kOpaque - value); });
  }
  return white;
}

void set_alpha(const RgbImage& map, RgbImage& image) {
  const bool fits = map.width == image.width && map.height == image.height;
  image.alpha = fits ? map.alpha : shrink(map, image.width, image.height).alpha;
}

void correct_reversed_alpha(const aiScene& scene, SourceModel& model) {
  std::set<unsigned> used;
  for (const aiMesh* mesh : std::span(scene.mMeshes, scene.mNumMeshes)) {
    if (mesh->mMaterialIndex < model.materials.size()) used.insert(mesh->mMaterialIndex);
  }
  const auto hidden = [&model](unsigned index) { return is_invisible(model.materials[index], model); };
  const auto whole = [&](unsigned index) { return model.materials[index].alpha == kOpaque && !hidden(index); };
  if (std::ranges::none_of(used, hidden) || std::ranges::any_of(used, whole)) return;
  for (const unsigned index : used) {
    SourceMaterial& material = model.materials[index];
    // A texture without any alpha above 0 is left with its colours.
    if (material.alpha != kOpaque) material.alpha = static_cast<std::uint8_t>(kOpaque - material.alpha);
    material.alpha_mode = material.alpha == kOpaque ? AlphaMode::opaque : AlphaMode::blend;
  }
  model.warnings.emplace_back(
      "no material has an alpha of 1, and some have 0: drawn with 1 - alpha, because some exporters write the reverse");
}

}  // namespace zstrip::sim
