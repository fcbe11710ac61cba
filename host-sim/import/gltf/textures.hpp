// Textures of a glTF file: decoded pictures, their repetition, and the coordinates of vertices.
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

/// Converts a vertex's texture coordinates of one set to coordinates on the texture (KHR_texture_transform). Maps (u,
/// v) to rows * (u, v, 1).
struct GltfTexcoords {
  std::size_t set = 0;
  std::array<std::array<double, 3>, 2> rows{{{1, 0, 0}, {0, 1, 0}}};

  std::array<float, 2> on_texture(double u, double v) const;
  friend bool operator==(const GltfTexcoords&, const GltfTexcoords&) = default;
};

/// A material's use of a texture.
struct GltfTextureUse {
  std::size_t texture = 0;  ///< index in the file
  GltfTexcoords texcoords;
  std::array<TextureWrap, 2> wrap{TextureWrap::repeat, TextureWrap::repeat};  ///< of u and v
  friend bool operator==(const GltfTextureUse&, const GltfTextureUse&) = default;
};

class GltfTextures {
 public:
  GltfTextures(const GltfDocument& document, GltfBuffers& buffers, SourceModel& model)
      : document_(document), buffers_(buffers), model_(model) {}

  /// Returns the use in a member of a material ("baseColorTexture"); nothing if the member does not exist.
  std::optional<GltfTextureUse> use_of(const GltfJson& material, const char* key) const;
  /// Returns the index into SourceModel::textures; kNoSourceTexture, with a warning, if the texture cannot be read.
  std::uint32_t read(std::size_t texture);
  /// Returns the mean of all its texels, 0..1 a channel; all ones, with a warning, if it cannot be read. The model does
  /// not keep the texture.
  std::array<double, 3> mean_of(std::size_t texture);

 private:
  std::optional<std::size_t> image_of(const GltfJson& texture) const;
  Result<RgbImage> decode(const GltfJson& image) const;
  Result<RgbImage> image(std::size_t texture) const;
  /// Returns the image's name, or the name of its file, for messages.
  std::string name_of(std::size_t texture) const;

  const GltfDocument& document_;
  GltfBuffers& buffers_;
  SourceModel& model_;
  /// Textures by image, or by texture if it has no image (false); also those that failed.
  std::map<std::pair<bool, std::size_t>, std::uint32_t> known_;
  std::map<std::size_t, std::array<double, 3>> means_;  ///< by texture; also textures that failed
};

}  // namespace zstrip::sim
