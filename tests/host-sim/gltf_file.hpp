// glTF 2.0 files made to measure, whole in their text: squares with any materials, in any nodes.
#pragma once

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

}  // namespace zstrip::sim::test
