// Views that are compressed with EXT_meshopt_compression.
#include "import/gltf/meshopt_views.hpp"

#include <meshoptimizer.h>

#include <string>

#include "import/gltf/document.hpp"

namespace zstrip::sim {
namespace {

/// More bytes than any model with an accepted number of triangles needs: a small file must not request gigabytes.
constexpr std::size_t kMaxDecodedBytes = std::size_t{1} << 31;

}  // namespace

Result<std::vector<std::uint8_t>> decode_meshopt(const GltfJson& compression, std::span<const std::uint8_t> bytes) {
  const std::size_t count = index_in(compression, "count").value_or(0);
  const std::size_t stride = index_in(compression, "byteStride").value_or(0);
  const std::string mode = text_in(compression, "mode"), filter = text_in(compression, "filter");
  if (count == 0 || stride == 0 || stride > 256 || count > kMaxDecodedBytes / stride) {
    return gltf_damaged("a compressed view has a size out of range");
  }
  std::vector<std::uint8_t> decoded(count * stride);
  // The decoders require this.
  const bool vertices = mode == "ATTRIBUTES" && stride % 4 == 0;
  const bool indices = stride == 2 || stride == 4;
  int status = -1;
  if (vertices) {
    status = meshopt_decodeVertexBuffer(decoded.data(), count, stride, bytes.data(), bytes.size());
  } else if (mode == "TRIANGLES" && indices && count % 3 == 0) {
    status = meshopt_decodeIndexBuffer(decoded.data(), count, stride, bytes.data(), bytes.size());
  } else if (mode == "INDICES" && indices) {
    status = meshopt_decodeIndexSequence(decoded.data(), count, stride, bytes.data(), bytes.size());
  }
  if (status != 0) return gltf_damaged("a compressed view is damaged");
  if (filter.empty() || filter == "NONE") return decoded;
  if (vertices && filter == "OCTAHEDRAL" && (stride == 4 || stride == 8)) {
    meshopt_decodeFilterOct(decoded.data(), count, stride);
  } else if (vertices && filter == "QUATERNION" && stride == 8) {
    meshopt_decodeFilterQuat(decoded.data(), count, stride);
  } else if (vertices && filter == "EXPONENTIAL") {
    meshopt_decodeFilterExp(decoded.data(), count, stride);
  } else {
    return gltf_damaged("a compressed view has a filter that does not fit it");
  }
  return decoded;
}

}  // namespace zstrip::sim
