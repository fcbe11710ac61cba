// Primitives that are compressed with KHR_draco_mesh_compression.
#include "import/gltf/draco_meshes.hpp"

#include <draco/compression/decode.h>
#include <fmt/format.h>

#include <memory>
#include <utility>

#include "import/gltf/document.hpp"

namespace zstrip::sim {
namespace {

/// Returns the values of each point; nothing if the attribute does not exist or has more components than glTF allows.
Result<GltfValues<float>> values_of(const draco::Mesh& mesh, std::size_t id) {
  const draco::PointAttribute* const attribute =
      id <= 0xFFFFFFFF ? mesh.GetAttributeByUniqueId(static_cast<std::uint32_t>(id)) : nullptr;
  if (attribute == nullptr || attribute->num_components() < 1 || attribute->num_components() > 4) {
    return gltf_damaged("a compressed mesh lacks an attribute");
  }
  const auto components = static_cast<std::int8_t>(attribute->num_components());
  GltfValues<float> values{.components = static_cast<std::size_t>(components), .numbers = {}};
  values.numbers.resize(values.components * mesh.num_points());
  for (std::uint32_t i = 0; i < mesh.num_points(); ++i) {
    const draco::AttributeValueIndex at = attribute->mapped_index(draco::PointIndex(i));
    if (at.value() >= attribute->size() ||
        !attribute->ConvertValue<float>(at, components, values.numbers.data() + i * values.components)) {
      return gltf_damaged("a compressed mesh has a damaged attribute");
    }
  }
  return values;
}

}  // namespace

Result<DracoMesh> decode_draco(const GltfJson& compression, std::span<const std::uint8_t> bytes) {
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  draco::Decoder decoder;
  auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
  if (!decoded.ok()) return gltf_damaged("a compressed mesh is damaged");
  const std::unique_ptr<draco::Mesh> mesh = std::move(decoded).value();
  DracoMesh read;
  for (const auto& [name, id] : member(compression, "attributes").items()) {
    Result<GltfValues<float>> values = values_of(*mesh, to_index(id).value_or(0xFFFFFFFF));
    if (!values) return values.failure();
    read.attributes.emplace(name, std::move(*values));
  }
  for (std::uint32_t i = 0; i < mesh->num_faces(); ++i) {
    const draco::Mesh::Face& face = mesh->face(draco::FaceIndex(i));
    read.indices.insert(read.indices.end(), {face[0].value(), face[1].value(), face[2].value()});
  }
  return read;
}

}  // namespace zstrip::sim
