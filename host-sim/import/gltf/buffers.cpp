// The bytes of a glTF file: buffers in the file, next to it or in data URIs, and views of them.
#include "import/gltf/buffers.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "import/gltf/data_uri.hpp"
#include "import/gltf/meshopt_views.hpp"
#include "text/text.hpp"

namespace zstrip::sim {

Result<std::vector<std::uint8_t>> GltfBuffers::read_uri(const std::string& uri) const {
  if (!is_data_uri(uri)) return read_(uri);
  std::optional<std::vector<std::uint8_t>> bytes = bytes_of_data_uri(uri);
  if (!bytes) return gltf_damaged("has a damaged data URI");
  return std::move(*bytes);
}

Result<std::span<const std::uint8_t>> GltfBuffers::buffer(std::size_t index) {
  const GltfJson& from = element(member(document_.json, "buffers"), index);
  const std::size_t length = index_in(from, "byteLength").value_or(0);
  const std::string uri = text_in(from, "uri");
  std::span<const std::uint8_t> whole;
  if (uri.empty() && index == 0 && document_.binary) {
    whole = *document_.binary;
  } else if (!uri.empty()) {
    const auto known = buffers_.find(index);
    if (known != buffers_.end()) {
      whole = known->second;
    } else {
      Result<std::vector<std::uint8_t>> bytes = read_uri(uri);
      if (!bytes) {
        const std::string name = is_data_uri(uri) ? std::string() : fmt::format(" '{}'", printable(uri));
        return gltf_damaged(fmt::format("its buffer {}{} {}", index, name, bytes.failure().message));
      }
      whole = buffers_.emplace(index, std::move(*bytes)).first->second;
    }
  } else {
    return gltf_damaged(fmt::format("there is no buffer {}", index));
  }
  if (length > whole.size()) return gltf_damaged(fmt::format("its buffer {} has fewer bytes than it says", index));
  return whole.first(length);
}

Result<std::span<const std::uint8_t>> GltfBuffers::part_of_buffer(const GltfJson& part, const std::string& name) {
  const std::optional<std::size_t> index = index_in(part, "buffer");
  if (!index) return gltf_damaged(fmt::format("there is no {}", name));
  const Result<std::span<const std::uint8_t>> whole = buffer(*index);
  if (!whole) return whole.failure();
  const std::size_t offset = index_in(part, "byteOffset").value_or(0);
  const std::size_t length = index_in(part, "byteLength").value_or(0);
  if (offset > whole->size() || length > whole->size() - offset) {
    return gltf_damaged(fmt::format("{} reaches beyond its buffer", name));
  }
  return whole->subspan(offset, length);
}

Result<GltfBuffers::View> GltfBuffers::compressed_view(std::size_t index, const GltfJson& compression) {
  const std::size_t stride = index_in(compression, "byteStride").value_or(0);
  const auto known = decoded_.find(index);
  if (known != decoded_.end()) return View{known->second, stride};
  const Result<std::span<const std::uint8_t>> bytes = part_of_buffer(compression, fmt::format("buffer view {}", index));
  if (!bytes) return bytes.failure();
  Result<std::vector<std::uint8_t>> decoded = decode_meshopt(compression, *bytes);
  if (!decoded) return decoded.failure();
  return View{decoded_.emplace(index, std::move(*decoded)).first->second, stride};
}

Result<GltfBuffers::View> GltfBuffers::view(std::size_t index) {
  const GltfJson& from = element(member(document_.json, "bufferViews"), index);
  const GltfJson& compression = extension(from, kMeshoptCompression);
  if (compression.is_object()) return compressed_view(index, compression);
  const Result<std::span<const std::uint8_t>> bytes = part_of_buffer(from, fmt::format("buffer view {}", index));
  if (!bytes) return bytes.failure();
  return View{*bytes, index_in(from, "byteStride").value_or(0)};
}

}  // namespace zstrip::sim
