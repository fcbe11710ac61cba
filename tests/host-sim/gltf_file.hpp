// glTF 2.0 files made to measure, whole in their text: squares with any materials, in any nodes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace zstrip::sim::test {

/// Bytes in base64 (RFC 4648).
std::string base64(const std::string& bytes);
/// The bytes of floats.
std::string floats(const std::vector<float>& values);
/// A PNG of four bytes a pixel.
std::string rgba_png(std::uint32_t width, std::uint32_t height, const std::vector<std::uint8_t>& rgba);

/// JSON objects without commas between them. Mesh n is a square of side 2 around the origin that faces +z, with
/// material n and texture coordinates.
struct GltfFile {
  std::vector<std::string> materials;
  std::vector<std::string> nodes;  ///< all of them roots
  std::string pictures{};          ///< of images and textures, the same index: a PNG; empty: none
  std::string lights{};            ///< of KHR_lights_punctual, with commas; empty: none

  std::string text() const;
};

/// Accessors of a file, and the bytes behind them: one buffer, a view for each accessor.
class GltfData {
 public:
  /// `what`: of the accessor, without its view ("\"componentType\":5126,..."). `of_view`: with a comma in front.
  /// Returns the accessor's index.
  std::size_t add(const std::string& bytes, const std::string& what, const std::string& of_view = "");
  /// Of floats, with their count ("VEC3").
  std::size_t add_floats(const std::vector<float>& values, const std::string& type);
  /// Of unsigned shorts, one each.
  std::size_t add_indices(const std::vector<std::uint16_t>& values);
  const std::string& bytes() const { return bytes_; }
  /// `"accessors":[...],"bufferViews":[...],"buffers":[...]`; `uri`: of the buffer, with a comma in front; without, its
  /// own bytes.
  std::string json(const std::string& uri) const;
  std::string json() const;

 private:
  std::string bytes_, views_, accessors_;
  std::size_t count_ = 0;
};

/// A whole file of one root node: asset, scene, and `members` ("\"nodes\":[...],..."), with commas between them.
std::string gltf_of(const std::string& members);
/// The same as a .glb; `binary`: its second chunk.
std::string glb_of(const std::string& json, const std::string& binary);

}  // namespace zstrip::sim::test
