// Views that are compressed with EXT_meshopt_compression, decoded by meshoptimizer.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "import/gltf/json.hpp"
#include "result.hpp"

namespace zstrip::sim {

inline constexpr const char* kMeshoptCompression = "EXT_meshopt_compression";

/// `compression`: the extension of the view, which describes `bytes`. The failure's message is a reason.
Result<std::vector<std::uint8_t>> decode_meshopt(const GltfJson& compression, std::span<const std::uint8_t> bytes);

}  // namespace zstrip::sim
