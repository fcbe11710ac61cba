// Extensions of a glTF file: those that the reader knows, and what the picture lacks of others.
#pragma once

#include <string>
#include <vector>

#include "import/gltf/json.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// Fails, by name, where the file requires extensions that are not known; the message starts with a verb. Adds one
/// warning for those that it only uses.
Result<Done> check_gltf_extensions(const GltfJson& json, std::vector<std::string>& warnings);

}  // namespace zstrip::sim
