// Textures of a glTF file: decoded pictures, how they repeat, and where on them a vertex is.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "import/gltf/buffers.hpp"
#include "import/gltf/json.hpp"
#include "import/source_model.hpp"

namespace zstrip::sim {

/// From a vertex' texture coordinates of one set to those on the texture (KHR_texture_transform). Maps (u, v) to
/// rows * (u, v, 1).
struct GltfTexcoords {
  std::size_t set = 0;
  std::array<std::array<double, 3>, 2> rows{{{1, 0, 0}, {0, 1, 0}}};

  std::array<float, 2> on_texture(double u, double v) const;
  friend bool operator==(const GltfTexcoords&, const GltfTexcoords&) = default;
};

/// What a material says of a texture that it has.
struct GltfTextureUse {
  std::size_t texture = 0;  ///< of the file
  GltfTexcoords texcoords;
  std::array<TextureWrap, 2> wrap{TextureWrap::repeat, TextureWrap::repeat};  ///< of u and v
  friend bool operator==(const GltfTextureUse&, const GltfTextureUse&) = default;
};

class GltfTextures {
 public:
  GltfTextures(const GltfDocument& document, GltfBuffers& buffers, SourceModel& model)
      : document_(document), buffers_(buffers), model_(model) {}

  /// Of a member of a material ("baseColorTexture"); none where it has none.
  std::optional<GltfTextureUse> use_of(const GltfJson& material, const char* key) const;
  /// Index into SourceModel::textures; kNoSourceTexture, with a warning, where it cannot be read.
  std::uint32_t read(std::size_t texture);
  /// Of all its texels, 0..1 a channel; all ones, with a warning, where it cannot be read. The model does not keep it.
  std::array<double, 3> mean_of(std::size_t texture);

 private:
  std::optional<std::size_t> image_of(const GltfJson& texture) const;
  Result<RgbImage> decode(const GltfJson& image) const;
  Result<RgbImage> image(std::size_t texture) const;
  /// The image's, its own or its file's, for messages.
  std::string name_of(std::size_t texture) const;

  const GltfDocument& document_;
  GltfBuffers& buffers_;
  SourceModel& model_;
  /// By image, or texture where there is none (false); also those that failed.
  std::map<std::pair<bool, std::size_t>, std::uint32_t> known_;
  std::map<std::size_t, std::array<double, 3>> means_;  ///< by texture; likewise
};

}  // namespace zstrip::sim
