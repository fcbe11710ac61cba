// The bytes of a glTF file: buffers in the file, beside it or in data URIs, and views of them.
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

/// Each buffer is read once, each compressed view decoded once; what is returned stays valid as long as this.
class GltfBuffers {
 public:
  GltfBuffers(const GltfDocument& document, const ReadUri& read) : document_(document), read_(read) {}

  struct View {
    std::span<const std::uint8_t> bytes;
    std::size_t stride = 0;  ///< 0: elements lie next to each other
  };
  Result<View> view(std::size_t index);
  /// Of a data URI, or what `read` finds.
  Result<std::vector<std::uint8_t>> read_uri(const std::string& uri) const;

 private:
  Result<std::span<const std::uint8_t>> buffer(std::size_t index);
  /// `length` bytes of a buffer that an object (a view, or its extension) means.
  Result<std::span<const std::uint8_t>> part_of_buffer(const GltfJson& part, const std::string& name);
  Result<View> compressed_view(std::size_t index, const GltfJson& compression);

  const GltfDocument& document_;
  const ReadUri& read_;
  std::map<std::size_t, std::vector<std::uint8_t>> buffers_;
  std::map<std::size_t, std::vector<std::uint8_t>> decoded_;  ///< of compressed views
};

}  // namespace zstrip::sim
