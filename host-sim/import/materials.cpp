// Assimp's materials and textures as source materials and decoded pictures.
#include "import/materials.hpp"

#include <assimp/GltfMaterial.h>
#include <assimp/commonMetaData.h>
#include <assimp/material.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "image/decode.hpp"
#include "import/read_file.hpp"
#include "report/text.hpp"

namespace zstrip::sim {
namespace {

/// What a file without materials is drawn with; Assimp's own default is darker.
constexpr std::array<std::uint8_t, 3> kDefaultColour{204, 204, 204};

Result<RgbImage> decode_embedded(const aiTexture& texture) {
  if (texture.mHeight == 0) {  // a whole picture file of mWidth bytes
    return decode_image({reinterpret_cast<const std::uint8_t*>(texture.pcData), texture.mWidth});
  }
  if (texture.mWidth == 0 || texture.mWidth > kMaxImageSide || texture.mHeight > kMaxImageSide) {
    return Failure{ExitStatus::input, "has a size out of range"};
  }
  RgbImage image{texture.mWidth, texture.mHeight, {}};
  for (const aiTexel& texel : std::span(texture.pcData, std::size_t{texture.mWidth} * texture.mHeight)) {
    image.rgb.insert(image.rgb.end(), {texel.r, texel.g, texel.b});
  }
  return image;
}

/// `path`, or the file of its folder whose name differs only in upper and lower case: other systems do not distinguish
/// them. Of several the first in the alphabet, so that every run takes the same.
std::filesystem::path find_in_any_case(const std::filesystem::path& path) {
  std::error_code ignored;
  if (std::filesystem::exists(path, ignored)) return path;
  const auto lower = [](std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return text;
  };
  const std::string wanted = lower(path.filename().string());
  std::filesystem::path found;
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  std::filesystem::directory_iterator entry(folder, ignored);
  for (; !ignored && entry != std::filesystem::directory_iterator(); entry.increment(ignored)) {
    std::filesystem::path name = entry->path().filename();
    if (lower(name.string()) == wanted && (found.empty() || name < found)) found = std::move(name);
  }
  return found.empty() ? path : path.parent_path() / found;
}

/// The file beside the model that `name` means: as it stands, or, for paths of another machine, its last part. Upper
/// and lower case of the last part may differ.
std::filesystem::path find_texture(const std::filesystem::path& folder, std::string name) {
  std::replace(name.begin(), name.end(), '\\', '/');
  std::filesystem::path as_given = find_in_any_case(folder / name);
  std::error_code ignored;
  if (std::filesystem::exists(as_given, ignored)) return as_given;
  const std::filesystem::path beside = find_in_any_case(folder / std::filesystem::path(name).filename());
  return std::filesystem::is_regular_file(beside, ignored) ? beside : as_given;
}

/// A cutoff above 1 hides everything, one of 0 nothing.
void set_cutoff(float cutoff, SourceMaterial& to) {
  if (cutoff > 1) to.alpha = 0;
  to.alpha_cutoff = to_screen_channel(cutoff, false);
  if (to.alpha_cutoff == 0) to.alpha_mode = AlphaMode::opaque;
}

}  // namespace

std::uint8_t to_screen_channel(double value, bool linear) {
  if (!(value > 0)) return 0;
  double clamped = std::min(value, 1.0);
  if (linear) clamped = clamped <= 0.0031308 ? 12.92 * clamped : 1.055 * std::pow(clamped, 1 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255 * clamped));
}

MaterialReader::MaterialReader(const aiScene& scene, std::filesystem::path folder, SourceModel& model)
    : scene_(scene), folder_(std::move(folder)), model_(model) {
  aiString format;
  if (scene.mMetaData != nullptr && scene.mMetaData->Get(AI_METADATA_SOURCE_FORMAT, format)) {
    linear_colours_ = std::string(format.C_Str()).find("glTF2") != std::string::npos;
  }
}

void MaterialReader::read_all() {
  for (const aiMaterial* material : std::span(scene_.mMaterials, scene_.mNumMaterials)) {
    unsigned texcoord_set = 0;
    model_.materials.push_back(read(*material, texcoord_set));
    texcoord_sets_.push_back(texcoord_set);
  }
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
    to.colour = {to_screen_channel(colour.r, linear_colours_), to_screen_channel(colour.g, linear_colours_),
                 to_screen_channel(colour.b, linear_colours_)};
  }
  int shading = 0;
  if (from.Get(AI_MATKEY_SHADING_MODEL, shading) == AI_SUCCESS) {
    to.lit = shading != aiShadingMode_Unlit;
    to.smooth = shading != aiShadingMode_Flat;
  }
  int two_sided = 0;
  if (from.Get(AI_MATKEY_TWOSIDED, two_sided) == AI_SUCCESS) to.double_sided = two_sided != 0;

  aiString texture;
  for (const aiTextureType type : {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE}) {
    if (from.Get(AI_MATKEY_TEXTURE(type, 0), texture) != AI_SUCCESS || texture.length == 0) continue;
    to.texture = read_texture(texture.C_Str());
    int set = 0;
    if (from.Get(AI_MATKEY_UVWSRC(type, 0), set) == AI_SUCCESS && set >= 0) texcoord_set = static_cast<unsigned>(set);
    break;
  }
  // Exporters write black, or nothing, beside a texture that is to be seen as it is.
  const bool textured = to.texture != kNoSourceTexture;
  if (textured && (is_default || to.colour == std::array<std::uint8_t, 3>{0, 0, 0})) to.colour = {255, 255, 255};
  if (linear_colours_) {
    read_effects(from, texture, to);
    if (to.alpha_mode != AlphaMode::opaque) to.alpha = to_screen_channel(colour.a, false);
    float cutoff = 0.5F;
    from.Get(AI_MATKEY_GLTF_ALPHACUTOFF, cutoff);
    if (to.alpha_mode == AlphaMode::mask) set_cutoff(cutoff, to);
  }
  return to;
}

void MaterialReader::read_effects(const aiMaterial& from, const aiString& texture, SourceMaterial& to) {
  aiColor3D emissive(0, 0, 0);
  if (to.lit && from.Get(AI_MATKEY_COLOR_EMISSIVE, emissive) == AI_SUCCESS &&
      std::max({emissive.r, emissive.g, emissive.b}) > 0) {
    aiString own;
    const bool has_own = from.Get(AI_MATKEY_TEXTURE(aiTextureType_EMISSIVE, 0), own) == AI_SUCCESS && own.length > 0;
    if (has_own && own != texture) {
      model_.warnings.push_back(
          fmt::format("material '{}' drawn without its emission: it has a texture of its own", printable(to.name)));
    } else {
      to.emissive = {to_screen_channel(emissive.r, true), to_screen_channel(emissive.g, true),
                     to_screen_channel(emissive.b, true)};
    }
  }
  aiString mode;
  if (from.Get(AI_MATKEY_GLTF_ALPHAMODE, mode) != AI_SUCCESS) return;
  if (mode == aiString("MASK")) to.alpha_mode = AlphaMode::mask;
  if (mode == aiString("BLEND")) to.alpha_mode = AlphaMode::blend;
}

std::uint32_t MaterialReader::read_texture(const std::string& name) {
  const auto known = known_textures_.find(name);
  if (known != known_textures_.end()) return known->second;
  std::string title = name;
  Result<RgbImage> image = [&]() -> Result<RgbImage> {
    if (const aiTexture* embedded = scene_.GetEmbeddedTexture(name.c_str())) return decode_embedded(*embedded);
    const std::filesystem::path path = find_texture(folder_, name);
    title = path.string();
    const Result<std::vector<std::uint8_t>> file = read_file(path);
    if (!file) return file.failure();
    return decode_image(*file);
  }();
  std::uint32_t index = kNoSourceTexture;
  if (image) {
    index = static_cast<std::uint32_t>(model_.textures.size());
    model_.textures.push_back(std::move(*image));
  } else {
    model_.warnings.push_back(
        fmt::format("texture '{}' {}; what uses it is drawn without", title, image.failure().message));
  }
  known_textures_.emplace(name, index);
  return index;
}

}  // namespace zstrip::sim
