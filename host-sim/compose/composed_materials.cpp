// The materials of a composed scene, with their textures and finishes: each once for each override.
#include "compose/composed_materials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "image/decode.hpp"
#include "image/mipmaps.hpp"
#include "image/palette.hpp"
#include "image/resample.hpp"
#include "import/quantise.hpp"
#include "import/read_file.hpp"

namespace zstrip::sim {
namespace {

Material replaced(Material material, const FileMaterial& by) {
  material.colour = by.colour.value_or(material.colour);
  material.colour.a = by.alpha.value_or(material.colour.a);
  material.lit = by.lit.value_or(material.lit);
  material.smooth = by.smooth.value_or(material.smooth);
  material.double_sided = by.double_sided.value_or(material.double_sided);
  material.depth_test = by.depth_test.value_or(material.depth_test);
  material.depth_write = by.depth_write.value_or(material.depth_write);
  material.depth_bias = by.depth_bias.value_or(material.depth_bias);
  return material;
}

}  // namespace

Result<std::uint16_t> ComposedMaterials::index_of(const PlacedPart& placed) {
  const FileMaterial* const other = override_of(placed);
  if (other != nullptr && other->mirrors && placed.part->mesh.normals.empty()) {
    return at_line(file_.path, other->texture_line,
                   fmt::format("material '{}' has an environment, but the model '{}' has no normals for it",
                               other->name, placed.file->model));
  }
  if (other != nullptr && other->texture && !other->mirrors && placed.part->mesh.texcoords.empty()) {
    return at_line(file_.path, other->texture_line,
                   fmt::format("material '{}' has a texture, but the model '{}' has no texture coordinates for it",
                               other->name, placed.file->model));
  }
  const auto key = std::tuple(placed.model_index, placed.part->material, other);
  const auto [at, is_new] = materials_.try_emplace(key, static_cast<std::uint16_t>(scene_.materials.size()));
  if (!is_new) return at->second;
  Material material = placed.model->materials[placed.part->material];
  std::string name = placed.model->material_names[placed.part->material];
  std::string origin = fmt::format("model '{}'", placed.file->model);
  const Finish finish =
      material.finish < placed.model->finishes.size() ? placed.model->finishes[material.finish] : Finish{};
  if (material.finish != kNoFinish && other == nullptr && !set_finish(material, finish, FileMaterial{})) {
    return too_many_finishes(placed.file->line);
  }
  if (other != nullptr && other->texture) {
    const Result<std::uint16_t> texture = own_texture(*other);
    if (!texture) return texture.failure();
    material.texture = *texture;
  } else if (material.texture != kNoTexture) {
    material.texture =
        model_texture(placed, material.texture, other != nullptr ? other->mipmaps : std::optional<bool>{});
  } else if (other != nullptr && other->mipmaps.value_or(false)) {
    return at_line(file_.path, other->mipmaps_line,
                   fmt::format("material '{}' has mipmaps, but neither a texture of its own nor one of the model '{}'",
                               other->name, placed.file->model));
  }
  if (other != nullptr) {
    material = replaced(material, *other);
    if (!set_finish(material, finish, *other)) return too_many_finishes(other->line);
    name = other->name;
    origin = origin_of(file_.path, other->line);
  }
  scene_.materials.push_back(material);
  scene_.material_names.push_back(name);
  scene_.material_origins.push_back(origin);
  return at->second;
}

Result<std::uint16_t> ComposedMaterials::index_of(const FileMaterial& own) {
  constexpr auto kNoModel = static_cast<std::size_t>(-1);
  const auto key = std::tuple(kNoModel, std::uint16_t{0}, &own);
  const auto [at, is_new] = materials_.try_emplace(key, static_cast<std::uint16_t>(scene_.materials.size()));
  if (!is_new) return at->second;
  Material material = replaced({}, own);
  if (own.texture) {
    const Result<std::uint16_t> texture = own_texture(own);
    if (!texture) return texture.failure();
    material.texture = *texture;
  }
  scene_.materials.push_back(material);
  scene_.material_names.push_back(own.name);
  scene_.material_origins.push_back(origin_of(file_.path, own.line));
  return at->second;
}

const FileMaterial* ComposedMaterials::override_of(const PlacedPart& placed) const {
  std::string name = placed.file->material;
  const std::string& own = placed.model->material_names[placed.part->material];
  for (const auto& [replaced, by] : placed.file->materials) {
    if (replaced == own) name = by;
  }
  const auto at = std::ranges::find(file_.materials, name, &FileMaterial::name);
  return name.empty() ? nullptr : &*at;
}

bool ComposedMaterials::may_texture(const std::string& model) const {
  const auto has_texture = [this](const std::string& material) {
    const auto at = std::ranges::find(file_.materials, material, &FileMaterial::name);
    return at != file_.materials.end() && at->texture && !at->mirrors;
  };
  return std::ranges::any_of(file_.instances, [&](const FileInstance& instance) {
    return instance.model == model &&
           (has_texture(instance.material) ||
            std::ranges::any_of(instance.materials, [&](const auto& pair) { return has_texture(pair.second); }));
  });
}

Result<std::uint16_t> ComposedMaterials::own_texture(const FileMaterial& material) {
  const std::filesystem::path path = file_.beside(*material.texture);
  const auto [at, is_new] = own_textures_.try_emplace({path, material.palette, material.mipmaps.value_or(false)},
                                                      static_cast<std::uint16_t>(scene_.textures.size()));
  if (!is_new) return at->second;
  const auto wrong = [&](const std::string& what) {
    return at_line(file_.path, material.texture_line, fmt::format("texture '{}' {}", path.string(), what));
  };
  const Result<std::vector<std::uint8_t>> bytes = read_file(path);
  if (!bytes) return wrong(bytes.failure().message);
  Result<RgbImage> image = decode_image(*bytes);
  if (!image) return wrong(image.failure().message);
  const RgbImage fitted = resample_to_power_of_two(std::move(*image));
  if (material.palette && !fitted.alpha.empty()) {
    return wrong("has alpha, which goes with no 'palette'; leave out one of them");
  }
  std::vector<std::uint16_t>& words = scene_.texels.emplace_back(to_rgb565(fitted));
  append_alpha(fitted, words);
  Texture texture{.texels = words,
                  .log2_width = static_cast<std::uint8_t>(log2_of(fitted.width)),
                  .log2_height = static_cast<std::uint8_t>(log2_of(fitted.height)),
                  .format = fitted.alpha.empty() ? TextureFormat::rgb565 : TextureFormat::rgb565_alpha};
  if (material.mipmaps.value_or(false)) add_levels(texture);
  if (material.palette) {
    texture.texels =
        scene_.texels.emplace_back(index_texels(texture.texels, *material.palette, level_sizes(texture)).words);
    texture.format = *material.palette;
  }
  scene_.textures.push_back(texture);
  return at->second;
}

std::uint16_t ComposedMaterials::model_texture(const PlacedPart& placed, std::uint16_t texture,
                                               std::optional<bool> mipmaps) {
  const auto key = std::tuple(placed.model_index, texture, mipmaps);
  const auto [at, is_new] = model_textures_.try_emplace(key, static_cast<std::uint16_t>(scene_.textures.size()));
  if (!is_new) return at->second;
  Texture own = placed.model->textures[texture];
  if (mipmaps == true) add_levels(own);
  if (mipmaps == false) own = without_smaller_levels(own);
  scene_.textures.push_back(own);
  return at->second;
}

void ComposedMaterials::add_levels(Texture& texture) {
  const std::uint8_t levels = most_smaller_levels(texture);
  texture.texels = scene_.texels.emplace_back(with_smaller_levels(texture, levels));
  texture.smaller_levels = levels;
}

/// Sets the material's finish if it needs one: its model's own, with the values that `by` replaces. Returns false if
/// the table is full.
bool ComposedMaterials::set_finish(Material& material, const Finish& own, const FileMaterial& by) {
  const bool has_own = material.finish != kNoFinish;
  if (!has_own && !by.has_finish()) return true;
  if (scene_.finishes.size() >= kNoFinish) return false;
  material.finish = static_cast<std::uint8_t>(scene_.finishes.size());
  const TextureFilter filter = by.filter.value_or(own.filter);
  scene_.finishes.push_back({.emissive = by.emissive.value_or(own.emissive),
                             .specular = by.specular.value_or(own.specular),
                             .shininess = by.shininess.value_or(own.shininess),
                             .alpha_mode = by.alpha_mode.value_or(own.alpha_mode),
                             .alpha_cutoff = by.alpha_cutoff.value_or(own.alpha_cutoff),
                             .filter = by.mirrors ? of_environment(filter) : filter});
  return true;
}

Failure ComposedMaterials::too_many_finishes(int line) const {
  return at_line(file_.path, line, "the scene has more than 255 finishes of materials");
}

}  // namespace zstrip::sim
