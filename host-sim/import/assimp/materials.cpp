// Converts Assimp's materials and textures to source materials and decoded pictures.
#include "import/assimp/materials.hpp"

#include <assimp/material.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "image/decode.hpp"
#include "import/assimp/linear_colours.hpp"
#include "import/assimp/opacity.hpp"
#include "import/ending.hpp"
#include "import/find_file.hpp"
#include "import/read_file.hpp"
#include "import/screen_channel.hpp"
#include "text/text.hpp"

namespace zstrip::sim {
namespace {

Result<RgbImage> decode_embedded(const aiTexture& texture) {
  if (texture.mHeight == 0) {  // a complete picture file of mWidth bytes
    return decode_image({reinterpret_cast<const std::uint8_t*>(texture.pcData), texture.mWidth});
  }
  if (texture.mWidth == 0) return Failure{ExitStatus::input, "has no pixels"};
  if (const Result<Done> fits = check_image_size(texture.mWidth, texture.mHeight); !fits) return fits.failure();
  RgbImage image{texture.mWidth, texture.mHeight, {}};
  for (const aiTexel& texel : std::span(texture.pcData, std::size_t{texture.mWidth} * texture.mHeight)) {
    image.rgb.insert(image.rgb.end(), {texel.r, texel.g, texel.b});
  }
  return image;
}

/// Decals end at their border; clamping is the nearest available mode.
TextureWrap wrap_of(const aiMaterial& from, const char* key, unsigned type, unsigned index) {
  int mode = aiTextureMapMode_Wrap;
  if (from.Get(key, type, index, mode) != AI_SUCCESS) return TextureWrap::repeat;
  if (mode == aiTextureMapMode_Mirror) return TextureWrap::mirror;
  return mode == aiTextureMapMode_Wrap ? TextureWrap::repeat : TextureWrap::clamp;
}

/// Returns the name of a material's texture; empty if it has none.
std::string texture_name(const aiMaterial& from, aiTextureType type) {
  aiString name;
  return from.Get(AI_MATKEY_TEXTURE(type, 0), name) == AI_SUCCESS ? name.C_Str() : "";
}

/// Maps of materials that are not drawn, by the words of the warning. Those of MTL have warnings of their own.
struct UndrawnMap {
  aiTextureType type;
  const char* name;
};
constexpr std::array<UndrawnMap, 6> kUndrawnMaps{{{aiTextureType_NORMALS, "normal maps"},
                                                  {aiTextureType_NORMAL_CAMERA, "normal maps"},
                                                  {aiTextureType_HEIGHT, "bump maps"},
                                                  {aiTextureType_LIGHTMAP, "light and occlusion maps"},
                                                  {aiTextureType_AMBIENT_OCCLUSION, "light and occlusion maps"},
                                                  {aiTextureType_EMISSIVE, "emission maps"}}};

void warn_of_maps(const aiScene& scene, std::vector<std::string>& warnings) {
  std::set<std::string_view> names;
  for (const aiMaterial* material : std::span(scene.mMaterials, scene.mNumMaterials)) {
    for (const UndrawnMap& map : kUndrawnMaps) {
      if (material->GetTextureCount(map.type) > 0) names.insert(map.name);
    }
  }
  std::string list;
  for (const std::string_view name : names) list += fmt::format("{}{}", list.empty() ? "" : ", ", name);
  if (!list.empty()) warnings.push_back("drawn without: " + list);
}

/// Returns a number of a material within 0..1, or nothing.
std::optional<double> share_of(const aiMaterial& from, const char* key, unsigned type, unsigned index) {
  float value = 0;
  if (from.Get(key, type, index, value) != AI_SUCCESS || !std::isfinite(value)) return std::nullopt;
  return std::clamp(double{value}, 0.0, 1.0);
}

}  // namespace

MaterialReader::MaterialReader(const aiScene& scene, const std::filesystem::path& path, SourceModel& model)
    : scene_(scene),
      folder_(path.parent_path()),
      is_blender_fbx_(lower(path.extension().string()) == ".fbx" && has_linear_colours(scene, path)),
      linear_(has_linear_colours(scene, path)),
      is_collada_(ending_of(path) == ".dae"),
      model_(model) {}

void MaterialReader::read_all() {
  for (const aiMaterial* material : std::span(scene_.mMaterials, scene_.mNumMaterials)) {
    unsigned texcoord_set = 0;
    model_.materials.push_back(read(*material, texcoord_set));
    texcoord_sets_.push_back(texcoord_set);
  }
  correct_reversed_alpha(scene_, model_);
  warn_of_maps(scene_, model_.warnings);
}

SourceMaterial MaterialReader::read(const aiMaterial& from, unsigned& texcoord_set) {
  SourceMaterial to;
  to.colour = kDefaultColour;
  aiString name;
  const bool is_default = from.Get(AI_MATKEY_NAME, name) == AI_SUCCESS && name == aiString(AI_DEFAULT_MATERIAL_NAME);
  if (!is_default) to.name = name.C_Str();
  aiColor4D colour(1, 1, 1, 1);
  if (!is_default && (from.Get(AI_MATKEY_BASE_COLOR, colour) == AI_SUCCESS ||
                      from.Get(AI_MATKEY_COLOR_DIFFUSE, colour) == AI_SUCCESS)) {
    to.colour = {to_screen_channel(colour.r, linear_), to_screen_channel(colour.g, linear_),
                 to_screen_channel(colour.b, linear_)};
  }
  read_metal(from, to);
  int shading = 0;
  if (from.Get(AI_MATKEY_SHADING_MODEL, shading) == AI_SUCCESS) {
    to.lit = shading != aiShadingMode_Unlit;
    to.smooth = shading != aiShadingMode_Flat;
  }
  int two_sided = 0;
  if (from.Get(AI_MATKEY_TWOSIDED, two_sided) == AI_SUCCESS) to.double_sided = two_sided != 0;

  const bool textured = read_textures(from, to, texcoord_set);
  // Exporters write black, or nothing, for a texture that is to be shown unchanged. Blender's texture replaces the
  // colour.
  if (textured && (is_default || linear_ || to.colour == std::array<std::uint8_t, 3>{0, 0, 0}))
    to.colour = {255, 255, 255};
  return to;
}

void MaterialReader::read_metal(const aiMaterial& from, SourceMaterial& to) const {
  to.metallic = share_of(from, AI_MATKEY_METALLIC_FACTOR).value_or(0);
  to.roughness = share_of(from, AI_MATKEY_ROUGHNESS_FACTOR).value_or(1);
  float shininess = 0;
  if (!is_blender_fbx_ || from.Get(AI_MATKEY_SHININESS, shininess) != AI_SUCCESS) return;
  // Releases before 2.77 write a share of 1 with black for no reflection.
  aiColor3D reflected;
  const bool is_black = from.Get(AI_MATKEY_COLOR_REFLECTIVE, reflected) == AI_SUCCESS && reflected.IsBlack();
  to.metallic = is_black ? 0 : share_of(from, AI_MATKEY_REFLECTIVITY).value_or(0);
  to.roughness = 1 - std::sqrt(std::clamp(double{shininess} / 100, 0.0, 1.0));
}

bool MaterialReader::read_textures(const aiMaterial& from, SourceMaterial& to, unsigned& texcoord_set) {
  const std::string map = texture_name(from, aiTextureType_OPACITY);
  std::string colours;
  aiTextureType placed = aiTextureType_OPACITY;
  for (const aiTextureType type : {aiTextureType_DIFFUSE, aiTextureType_BASE_COLOR}) {
    const std::string name = texture_name(from, type);
    if (name.empty()) continue;
    colours = name;
    placed = type;
  }
  double alpha = alpha_of(from);
  aiColor3D transparent;
  // Collada's RGB_ZERO, in which white is transparent: for a map Assimp computes the alpha of white.
  const bool inverted = is_collada_ && alpha < 0.5 && from.Get(AI_MATKEY_COLOR_TRANSPARENT, transparent) == AI_SUCCESS;
  const Texture texture = read_texture(colours, map, inverted);
  if (!map.empty() && texture.index != kNoSourceTexture && alpha == 0) alpha = 1;  // the map replaces it
  to.alpha = to_screen_channel(alpha, false);
  to.alpha_mode = to.alpha == 255 ? texture.alpha_mode : AlphaMode::blend;
  to.texture = texture.index;
  if (colours.empty() && map.empty()) return false;
  to.wrap = {wrap_of(from, AI_MATKEY_MAPPINGMODE_U(placed, 0)), wrap_of(from, AI_MATKEY_MAPPINGMODE_V(placed, 0))};
  int set = 0;
  if (from.Get(AI_MATKEY_UVWSRC(placed, 0), set) == AI_SUCCESS && set >= 0) texcoord_set = static_cast<unsigned>(set);
  return texture.has_colours;
}

MaterialReader::Texture MaterialReader::read_texture(const std::string& colours, const std::string& map,
                                                     bool inverted) {
  const auto [at, is_new] = known_textures_.try_emplace({colours, map, inverted});
  Texture& texture = at->second;
  if (!is_new) return texture;
  std::string title;
  std::optional<RgbImage> image = read_picture(colours, title);
  texture.has_colours = image.has_value();
  const bool is_own_map = !map.empty() && find_file(folder_, map) == find_file(folder_, colours);
  if (is_own_map && image) texture.alpha_mode = alpha_mode_of(*image);
  std::string map_title;
  const std::optional<RgbImage> values = is_own_map ? std::nullopt : read_picture(map, map_title);
  if (values) {
    RgbImage white = white_with_alpha_of(*values, inverted);
    texture.alpha_mode = alpha_mode_of(white);
    if (image) {
      set_alpha(white, *image);
    } else if (texture.alpha_mode != AlphaMode::opaque) {
      image = std::move(white);
      title = map_title;
    }
  }
  if (!image) return texture;
  texture.index = static_cast<std::uint32_t>(model_.textures.size());
  model_.textures.push_back(std::move(*image));
  model_.texture_names.push_back(title);
  return texture;
}

std::optional<RgbImage> MaterialReader::read_picture(const std::string& name, std::string& title) {
  if (name.empty()) return std::nullopt;
  title = name;
  Result<RgbImage> image = [&]() -> Result<RgbImage> {
    if (const aiTexture* embedded = scene_.GetEmbeddedTexture(name.c_str())) return decode_embedded(*embedded);
    const std::filesystem::path path = find_file(folder_, name);
    title = path.string();
    const Result<std::vector<std::uint8_t>> file = read_file(path);
    if (!file) return file.failure();
    return decode_image(*file);
  }();
  if (image) return std::move(*image);
  if (unread_pictures_.insert(name).second) {
    model_.warnings.push_back(
        fmt::format("texture '{}' {}; its surfaces are drawn without it", title, image.failure().message));
  }
  return std::nullopt;
}

}  // namespace zstrip::sim
