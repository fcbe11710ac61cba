// Primitives that are compressed with KHR_draco_mesh_compression, decoded by Draco.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "import/gltf/accessors.hpp"
#include "import/gltf/json.hpp"
#include "result.hpp"

namespace zstrip::sim {

inline constexpr const char* kDracoCompression = "KHR_draco_mesh_compression";

/// The data that accessors would otherwise have.
struct DracoMesh {
  std::map<std::string, GltfValues<float>> attributes;  ///< by name ("POSITION")
  std::vector<std::uint32_t> indices;                   ///< three a triangle
};

/// `compression`: the extension of the primitive, which names attributes of the mesh in `bytes`. The failure's message
/// is a reason.
Result<DracoMesh> decode_draco(const GltfJson& compression, std::span<const std::uint8_t> bytes);

}  // namespace zstrip::sim
