// Converts materials of a glTF file to source materials.
#include "import/gltf/materials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "import/gltf/highlights.hpp"
#include "import/gltf/specular_glossiness.hpp"
#include "import/metals.hpp"
#include "import/screen_channel.hpp"
#include "text/number.hpp"
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
  const auto tell = [this](std::size_t count, const char* maps) {
    if (count == 0) return;
    const bool rich = shine_.style == MaterialStyle::rich;
    model_.warnings.push_back(fmt::format("{} drawn without {}{}", counted(count, "material"), maps,
                                          rich ? ": a map needs a base texture at the same coordinates" : ""));
  };
  tell(without_normals_, "normal maps");
  tell(without_occlusion_, "occlusion maps");
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
  // An older extension for the same.
  const GltfJson& diffuse = extension(from, "KHR_materials_pbrSpecularGlossiness");
  const bool is_older = diffuse.is_object();
  const GltfJson& base = is_older ? diffuse : member(from, "pbrMetallicRoughness");
  const auto factor = numbers_in<4>(base, is_older ? "diffuseFactor" : "baseColorFactor", {1, 1, 1, 1});
  to.colour = on_screen(factor[0], factor[1], factor[2]);
  read_alpha(from, factor[3], to);
  const std::optional<GltfTextureUse> texture =
      is_older ? read_specular_glossiness(base, to) : textures_.use_of(base, "baseColorTexture");
  if (to.lit && !is_older) read_shine(from, texture.has_value(), to);
  texcoords = read_textures(texture, to.lit ? read_emission(from, texture, to) : std::nullopt, to);
  if (to.lit) read_maps(from, texture, to);
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

void GltfMaterials::read_shine(const GltfJson& from, bool textured, SourceMaterial& to) const {
  const GltfJson& base = member(from, "pbrMetallicRoughness");
  to.metallic = share(number_in(base, "metallicFactor", 1));
  to.roughness = share(number_in(base, "roughnessFactor", 1));
  const bool shines = shine_.highlights == Highlights::of_materials;
  // Its picture takes time to decode: only where it can change something.
  const bool mirrors = shine_.style == MaterialStyle::rich && !textured && to.metallic >= kMinMetal;
  GltfRoughness mean;
  const auto texture = textures_.use_of(base, "metallicRoughnessTexture");
  if (texture && (shines || mirrors)) {
    const std::array<double, 3> means = textures_.mean_of(texture->texture);
    mean = {.roughness = means[1], .metallic = means[2]};
    to.roughness *= mean.roughness;
    to.metallic *= mean.metallic;
  }
  if (shines) set_highlight(from, mean, to);
}

std::optional<GltfTextureUse> GltfMaterials::read_specular_glossiness(const GltfJson& from, SourceMaterial& to) const {
  const std::optional<GltfTextureUse> diffuse_texture = textures_.use_of(from, "diffuseTexture");
  const std::optional<GltfTextureUse> specular_texture = textures_.use_of(from, "specularGlossinessTexture");
  // Without a factor the format assumes a white mirror, which files hardly mean.
  if (!member(from, "specularFactor").is_array() && !specular_texture) return diffuse_texture;
  const auto diffuse = numbers_in<4>(from, "diffuseFactor", {1, 1, 1, 1});
  const auto specular = numbers_in<3>(from, "specularFactor", {1, 1, 1});
  const auto times_mean = [this](double factor, const std::optional<GltfTextureUse>& texture, std::size_t channel) {
    constexpr double kGamma = 2.2;  // of the screen, nearly
    return share(factor) * (texture ? std::pow(textures_.mean_of(texture->texture)[channel], kGamma) : 1);
  };
  SpecularGlossiness means;
  for (std::size_t i = 0; i < 3; ++i) {
    means.diffuse[i] = times_mean(diffuse[i], diffuse_texture, i);
    means.specular[i] = times_mean(specular[i], specular_texture, i);
  }
  const MetallicBase base = to_metallic(means);
  if (base.metallic < kMinMetal && (diffuse_texture || specular_texture)) return diffuse_texture;
  to.metallic = base.metallic;
  to.roughness = 1 - share(number_in(from, "glossinessFactor", 1));
  to.colour = specular_texture ? on_screen(specular[0], specular[1], specular[2])
                               : on_screen(base.colour[0], base.colour[1], base.colour[2]);
  return specular_texture;
}

void GltfMaterials::read_maps(const GltfJson& from, const std::optional<GltfTextureUse>& base, SourceMaterial& to) {
  const auto read_map = [&](const char* key, std::uint32_t& texture, std::size_t& without) {
    const std::optional<GltfTextureUse> map = textures_.use_of(from, key);
    if (!map) return;
    const bool fits = base && to.texture != kNoSourceTexture && map->texcoords == base->texcoords;
    if (fits && shine_.style == MaterialStyle::rich) {
      texture = textures_.read(map->texture);
    } else {
      ++without;
    }
  };
  read_map("normalTexture", to.normal_texture, without_normals_);
  read_map("occlusionTexture", to.occlusion_texture, without_occlusion_);
  constexpr double kMaxScale = 100;
  to.normal_scale = std::clamp(number_in(member(from, "normalTexture"), "scale", 1), -kMaxScale, kMaxScale);
  to.occlusion_strength = share(number_in(member(from, "occlusionTexture"), "strength", 1));
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
