// Textures of a glTF file.
#include "import/gltf/textures.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>
#include <vector>

#include "image/decode.hpp"
#include "import/gltf/data_uri.hpp"
#include "text/text.hpp"

namespace zstrip::sim {
namespace {

/// With a larger offset, coordinates in floats lose texels. Repeating textures look the same with another whole offset.
constexpr double kFarOffset = 16;
constexpr std::size_t kClampToEdge = 33071, kMirroredRepeat = 33648;
/// Formats that are not supported; a texture with no other format is left out, and the warning names its format.
constexpr std::array kOtherPictures{"KHR_texture_basisu", "EXT_texture_avif", "MSFT_texture_dds"};

TextureWrap wrap_of(const GltfJson& sampler, const char* key) {
  switch (index_in(sampler, key).value_or(0)) {
    case kClampToEdge: return TextureWrap::clamp;
    case kMirroredRepeat: return TextureWrap::mirror;
    default: return TextureWrap::repeat;
  }
}

/// Returns the map that scales, then rotates (counter-clockwise with v downwards), then translates.
GltfTexcoords texcoords_of(const GltfJson& use) {
  GltfTexcoords texcoords;
  texcoords.set = index_in(use, "texCoord").value_or(0);
  const GltfJson& transform = extension(use, "KHR_texture_transform");
  if (!transform.is_object()) return texcoords;
  texcoords.set = index_in(transform, "texCoord").value_or(texcoords.set);
  const auto offset = numbers_in<2>(transform, "offset", {0, 0}), scale = numbers_in<2>(transform, "scale", {1, 1});
  const double angle = number_in(transform, "rotation", 0);
  const double c = std::cos(angle), s = std::sin(angle);
  texcoords.rows = {{{c * scale[0], s * scale[1], offset[0]}, {-s * scale[0], c * scale[1], offset[1]}}};
  return texcoords;
}

}  // namespace

std::array<float, 2> GltfTexcoords::on_texture(double u, double v) const {
  const auto along = [&](const std::array<double, 3>& row) {
    return static_cast<float>(row[0] * u + row[1] * v + row[2]) + 0.0F;
  };
  return {along(rows[0]), along(rows[1])};
}

std::optional<GltfTextureUse> GltfTextures::use_of(const GltfJson& material, const char* key) const {
  const GltfJson& from = member(material, key);
  const std::optional<std::size_t> texture = index_in(from, "index");
  if (!texture) return std::nullopt;
  const GltfJson& json = element(member(document_.json, "textures"), *texture);
  GltfTextureUse use{.texture = *texture, .texcoords = texcoords_of(from)};
  if (const std::optional<std::size_t> index = index_in(json, "sampler")) {
    const GltfJson& sampler = element(member(document_.json, "samplers"), *index);
    use.wrap = {wrap_of(sampler, "wrapS"), wrap_of(sampler, "wrapT")};
  }
  for (std::size_t axis = 0; axis < 2; ++axis) {
    double& offset = use.texcoords.rows[axis][2];
    if (use.wrap[axis] != TextureWrap::clamp && std::abs(offset) > kFarOffset) offset = std::fmod(offset, 2);
  }
  return use;
}

Result<RgbImage> GltfTextures::decode(const GltfJson& image) const {
  if (const std::optional<std::size_t> view = index_in(image, "bufferView")) {
    const Result<GltfBuffers::View> bytes = buffers_.view(*view);
    if (!bytes) return Failure{ExitStatus::input, fmt::format("cannot be read: {}", bytes.failure().message)};
    return decode_image(bytes->bytes);
  }
  const std::string uri = text_in(image, "uri");
  if (uri.empty()) return Failure{ExitStatus::input, "has no picture"};
  const Result<std::vector<std::uint8_t>> bytes = buffers_.read_uri(uri);
  if (!bytes) return bytes.failure();
  return decode_image(*bytes);
}

std::optional<std::size_t> GltfTextures::image_of(const GltfJson& texture) const {
  const std::optional<std::size_t> webp = index_in(extension(texture, "EXT_texture_webp"), "source");
  return webp ? webp : index_in(texture, "source");
}

std::string GltfTextures::name_of(std::size_t texture) const {
  const GltfJson& json = element(member(document_.json, "textures"), texture);
  const std::optional<std::size_t> source = image_of(json);
  const GltfJson& image = source ? element(member(document_.json, "images"), *source) : json;
  const std::string uri = text_in(image, "uri");
  std::string name = text_in(image, "name");
  if (name.empty()) name = text_in(json, "name");
  if (name.empty() && !uri.empty() && !is_data_uri(uri)) name = uri;
  if (!name.empty()) return printable(name);
  return source ? fmt::format("images[{}]", *source) : fmt::format("textures[{}]", texture);
}

Result<RgbImage> GltfTextures::image(std::size_t texture) const {
  const GltfJson& json = element(member(document_.json, "textures"), texture);
  if (const std::optional<std::size_t> source = image_of(json)) {
    return decode(element(member(document_.json, "images"), *source));
  }
  for (const char* format : kOtherPictures) {
    if (!extension(json, format).is_object()) continue;
    return Failure{ExitStatus::input, fmt::format("is of {}, which is not read", format)};
  }
  return Failure{ExitStatus::input, "has no picture"};
}

std::array<double, 3> GltfTextures::mean_of(std::size_t texture) {
  const auto [at, is_new] = means_.try_emplace(texture, std::array<double, 3>{1, 1, 1});
  std::array<double, 3>& mean = at->second;
  if (!is_new) return mean;
  const Result<RgbImage> picture = image(texture);
  if (!picture) {
    model_.warnings.push_back(fmt::format("texture '{}' {}; highlights are drawn without", name_of(texture),
                                          printable(picture.failure().message)));
    return mean;
  }
  std::array<std::uint64_t, 3> sum{};
  for (std::size_t i = 0; i < picture->rgb.size(); ++i) sum[i % 3] += picture->rgb[i];
  const std::size_t texels = picture->rgb.size() / 3;
  for (std::size_t c = 0; c < 3; ++c) mean[c] = static_cast<double>(sum[c]) / (255 * static_cast<double>(texels));
  return mean;
}

std::uint32_t GltfTextures::read(std::size_t texture) {
  // Textures without an image are identified by their own index.
  const std::optional<std::size_t> source = image_of(element(member(document_.json, "textures"), texture));
  const std::pair key(source.has_value(), source.value_or(texture));
  const auto known = known_.find(key);
  if (known != known_.end()) return known->second;
  Result<RgbImage> decoded = image(texture);
  std::uint32_t index = kNoSourceTexture;
  if (decoded) {
    index = static_cast<std::uint32_t>(model_.textures.size());
    model_.textures.push_back(std::move(*decoded));
    model_.texture_names.push_back(name_of(texture));
  } else {
    model_.warnings.push_back(
        fmt::format("texture '{}' {}; its surfaces are drawn without it", name_of(texture), decoded.failure().message));
  }
  known_.emplace(key, index);
  return index;
}

}  // namespace zstrip::sim
