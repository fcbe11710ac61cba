// Converts materials of a glTF file to source materials.
#include "import/gltf/materials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "import/gltf/highlights.hpp"
#include "import/screen_channel.hpp"
#include "text/text.hpp"

namespace zstrip::sim {
namespace {

constexpr std::array<std::uint8_t, 3> kBlack{};

std::array<std::uint8_t, 3> on_screen(double r, double g, double b) {
  return {to_screen_channel(r, true), to_screen_channel(g, true), to_screen_channel(b, true)};
}

/// Alpha has an effect if the mode says so. A cutoff above 1 hides everything, a cutoff of 0 nothing.
void read_alpha(const GltfJson& from, double alpha, SourceMaterial& to) {
  const std::string mode = text_in(from, "alphaMode");
  if (mode == "BLEND") to.alpha_mode = AlphaMode::blend;
  if (mode == "MASK") to.alpha_mode = AlphaMode::mask;
  if (to.alpha_mode != AlphaMode::opaque) to.alpha = to_screen_channel(alpha, false);
  if (to.alpha_mode != AlphaMode::mask) return;
  const double cutoff = number_in(from, "alphaCutoff", 0.5);
  if (cutoff > 1) to.alpha = 0;
  to.alpha_cutoff = to_screen_channel(cutoff, false);
  if (to.alpha_cutoff == 0) to.alpha_mode = AlphaMode::opaque;
}

/// The share of light that other materials than metal reflect straight on, in glTF.
constexpr double kStraight = 0.04;

/// Perceived brightness, as KHR_materials_pbrSpecularGlossiness weighs it.
double brightness(const std::array<double, 3>& c) {
  return std::sqrt(0.299 * c[0] * c[0] + 0.587 * c[1] * c[1] + 0.114 * c[2] * c[2]);
}

/// Returns the base colour whose metal looks most like a diffuse and a specular colour: that of metal is all in the
/// specular one. The root of how much metal there is comes from the formulas of both models of light.
std::array<double, 3> base_of(const std::array<double, 4>& diffuse, const std::array<double, 3>& specular) {
  const double rest = 1 - std::clamp(*std::ranges::max_element(specular), 0.0, 1.0);
  const double of_diffuse = brightness({diffuse[0], diffuse[1], diffuse[2]}), of_specular = brightness(specular);
  double metal = 0;
  if (of_specular > kStraight) {
    const double b = of_diffuse * rest / (1 - kStraight) + of_specular - 2 * kStraight;
    metal = std::clamp((std::sqrt(b * b - 4 * kStraight * (kStraight - of_specular)) - b) / (2 * kStraight), 0.0, 1.0);
  }
  std::array<double, 3> base{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double plain = diffuse[i] * rest / (1 - kStraight) / std::max(1 - metal, 1e-6);
    const double shiny = (specular[i] - kStraight * (1 - metal)) / std::max(metal, 1e-6);
    base[i] = std::clamp(plain + (shiny - plain) * metal * metal, 0.0, 1.0);
  }
  return base;
}

}  // namespace

void GltfMaterials::read_all() {
  for (std::size_t i = 0; i < count_of(json_, "materials"); ++i) {
    GltfTexcoords texcoords;
    SourceMaterial material = read(element(member(json_, "materials"), i), texcoords);
    model_.materials.push_back(std::move(material));
    texcoords_.push_back(texcoords);
  }
  model_.materials.push_back({.name = "", .double_sided = false});
  texcoords_.resize(model_.materials.size());
}

std::uint32_t GltfMaterials::material_of(const GltfJson& primitive) const {
  const std::size_t count = count_of(json_, "materials");
  return static_cast<std::uint32_t>(std::min(index_in(primitive, "material").value_or(count), count));
}

SourceMaterial GltfMaterials::read(const GltfJson& from, GltfTexcoords& texcoords) {
  SourceMaterial to;
  to.name = text_in(from, "name");
  to.lit = !extension(from, "KHR_materials_unlit").is_object();
  to.double_sided = flag_in(from, "doubleSided");
  // An older extension for the same. Its specular colour is drawn where no texture has colours, too.
  const GltfJson& diffuse = extension(from, "KHR_materials_pbrSpecularGlossiness");
  const bool is_older = diffuse.is_object();
  const GltfJson& base = is_older ? diffuse : member(from, "pbrMetallicRoughness");
  auto factor = numbers_in<4>(base, is_older ? "diffuseFactor" : "baseColorFactor", {1, 1, 1, 1});
  if (is_older && member(base, "specularFactor").is_array() && !member(base, "diffuseTexture").is_object() &&
      !member(base, "specularGlossinessTexture").is_object()) {
    const std::array<double, 3> metallic = base_of(factor, numbers_in<3>(base, "specularFactor", {1, 1, 1}));
    std::ranges::copy(metallic, factor.begin());
  }
  to.colour = on_screen(factor[0], factor[1], factor[2]);
  read_alpha(from, factor[3], to);
  if (highlights_ == Highlights::of_materials && to.lit && !is_older) read_highlight(from, to);
  const std::optional<GltfTextureUse> texture =
      textures_.use_of(base, is_older ? "diffuseTexture" : "baseColorTexture");
  texcoords = read_textures(texture, to.lit ? read_emission(from, texture, to) : std::nullopt, to);
  return to;
}

std::optional<GltfTextureUse> GltfMaterials::read_emission(const GltfJson& from,
                                                           const std::optional<GltfTextureUse>& texture,
                                                           SourceMaterial& to) const {
  const double strength = number_in(extension(from, "KHR_materials_emissive_strength"), "emissiveStrength", 1);
  const auto factor = numbers_in<3>(from, "emissiveFactor", {0, 0, 0});
  to.emissive = on_screen(factor[0] * strength, factor[1] * strength, factor[2] * strength);
  if (to.emissive == kBlack) return std::nullopt;
  std::optional<GltfTextureUse> own = textures_.use_of(from, "emissiveTexture");
  if (own == texture) own.reset();
  return own;
}

void GltfMaterials::read_highlight(const GltfJson& from, SourceMaterial& to) const {
  GltfRoughness roughness;
  const auto texture = textures_.use_of(member(from, "pbrMetallicRoughness"), "metallicRoughnessTexture");
  if (texture) {
    const std::array<double, 3> mean = textures_.mean_of(texture->texture);
    roughness = {.roughness = mean[1], .metallic = mean[2]};
  }
  set_highlight(from, roughness, to);
}

GltfTexcoords GltfMaterials::read_textures(const std::optional<GltfTextureUse>& texture,
                                           std::optional<GltfTextureUse> emission, SourceMaterial& to) {
  const bool glows_alone = emission && to.colour == kBlack && to.alpha_mode == AlphaMode::opaque;
  if (emission && texture && !glows_alone &&
      (emission->texcoords != texture->texcoords || emission->wrap != texture->wrap)) {
    model_.warnings.push_back(
        fmt::format("material '{}' drawn without its emission: its texture lies otherwise than that of its colour",
                    printable(to.name)));
    emission.reset();
    to.emissive = kBlack;
  }
  if (emission) {
    to.emissive_texture = textures_.read(emission->texture);
    if (to.emissive_texture == kNoSourceTexture) to.emissive = kBlack;
  }
  if (texture && !glows_alone) to.texture = textures_.read(texture->texture);
  const std::optional<GltfTextureUse>& placed = texture && !glows_alone ? texture : emission;
  if (!placed) return {};
  to.wrap = placed->wrap;
  return placed->texcoords;
}

}  // namespace zstrip::sim
