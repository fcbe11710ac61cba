// The bytes of a glTF file: buffers in the file, next to it or in data URIs, and views of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "import/gltf/document.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// Reads each buffer once, and decodes each compressed view once; results stay valid as long as this object.
class GltfBuffers {
 public:
  GltfBuffers(const GltfDocument& document, const ReadUri& read) : document_(document), read_(read) {}

  struct View {
    std::span<const std::uint8_t> bytes;
    std::size_t stride = 0;  ///< 0: elements are adjacent
  };
  Result<View> view(std::size_t index);
  /// Returns the bytes of a data URI, or of the file that `read` finds.
  Result<std::vector<std::uint8_t>> read_uri(const std::string& uri) const;

 private:
  Result<std::span<const std::uint8_t>> buffer(std::size_t index);
  /// Returns `length` bytes of the buffer that an object (a view, or its extension) refers to.
  Result<std::span<const std::uint8_t>> part_of_buffer(const GltfJson& part, const std::string& name);
  Result<View> compressed_view(std::size_t index, const GltfJson& compression);

  const GltfDocument& document_;
  const ReadUri& read_;
  std::map<std::size_t, std::vector<std::uint8_t>> buffers_;
  std::map<std::size_t, std::vector<std::uint8_t>> decoded_;  ///< by compressed view
};

}  // namespace zstrip::sim
