// The numbers of a primitive.
#include "import/gltf/attributes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "import/gltf/document.hpp"

namespace zstrip::sim {
namespace {

template <typename Number>
Result<GltfValues<Number>> fitting(Result<GltfValues<Number>> read, std::size_t accessor, const std::string& what,
                                   std::size_t vertices, std::size_t least) {
  if (read && (read->components < least || read->components > 4 || read->count() < vertices)) {
    return gltf_damaged(fmt::format("accessor {} does not fit {}", accessor, what));
  }
  return read;
}

}  // namespace

Result<GltfValues<float>> fitting_floats(GltfAccessors& accessors, std::size_t accessor, const std::string& what,
                                         std::size_t vertices, std::size_t least) {
  return fitting(accessors.floats(accessor), accessor, what, vertices, least);
}

Result<GltfAttributes> GltfAttributes::open(const GltfJson& primitive, GltfAccessors& accessors, GltfBuffers& buffers) {
  GltfAttributes opened(primitive, accessors);
  const GltfJson& compression = extension(primitive, kDracoCompression);
  const std::optional<std::size_t> index = index_in(compression, "bufferView");
  if (!index) return opened;
  const Result<GltfBuffers::View> view = buffers.view(*index);
  if (!view) return view.failure();
  Result<DracoMesh> mesh = decode_draco(compression, view->bytes);
  if (!mesh) return mesh.failure();
  opened.compressed_ = std::move(*mesh);
  return opened;
}

const GltfValues<float>* GltfAttributes::decoded(const std::string& name) const {
  if (!compressed_) return nullptr;
  const auto at = compressed_->attributes.find(name);
  return at == compressed_->attributes.end() ? nullptr : &at->second;
}

bool GltfAttributes::has(const std::string& name) const {
  return decoded(name) != nullptr || index_in(member(*primitive_, "attributes"), name.c_str()).has_value();
}

Result<GltfValues<float>> GltfAttributes::floats(const std::string& name, std::size_t vertices,
                                                 std::size_t least) const {
  if (const GltfValues<float>* const values = decoded(name)) {
    if (values->components < least || values->count() < vertices) {
      return gltf_damaged(fmt::format("a compressed mesh does not fit {}", name));
    }
    return *values;
  }
  const std::optional<std::size_t> accessor = index_in(member(*primitive_, "attributes"), name.c_str());
  if (!accessor) return GltfValues<float>();
  return fitting_floats(*accessors_, *accessor, name, vertices, least);
}

Result<GltfValues<std::uint32_t>> GltfAttributes::integers(const std::string& name, std::size_t vertices,
                                                           std::size_t least) const {
  if (decoded(name) != nullptr) {
    const Result<GltfValues<float>> values = floats(name, vertices, least);
    if (!values) return values.failure();
    GltfValues<std::uint32_t> whole{.components = values->components, .numbers = {}};
    for (const float value : values->numbers) {
      whole.numbers.push_back(value > 0 ? static_cast<std::uint32_t>(std::min(value, 65535.0F)) : 0U);
    }
    return whole;
  }
  const std::optional<std::size_t> accessor = index_in(member(*primitive_, "attributes"), name.c_str());
  if (!accessor) return GltfValues<std::uint32_t>();
  return fitting(accessors_->integers(*accessor), *accessor, name, vertices, least);
}

Result<std::vector<std::uint32_t>> GltfAttributes::indices(std::size_t vertices) const {
  if (compressed_) return compressed_->indices;
  const std::optional<std::size_t> accessor = index_in(*primitive_, "indices");
  if (!accessor) {
    std::vector<std::uint32_t> all(vertices);
    std::iota(all.begin(), all.end(), 0U);
    return all;
  }
  Result<GltfValues<std::uint32_t>> read = accessors_->integers(*accessor);
  if (!read) return read.failure();
  if (read->components != 1) return gltf_damaged(fmt::format("accessor {} does not fit indices", *accessor));
  return std::move(read->numbers);
}

}  // namespace zstrip::sim
