// Extensions of a glTF file: those that the reader supports, and the missing features of others and of maps of
// materials.
#pragma once

#include <string>
#include <vector>

#include "import/gltf/json.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// Fails, with the name, if the file requires extensions that are not supported; the message starts with a verb. Adds
/// one warning for those that the file only uses, and for the maps of its materials that are not drawn.
Result<Done> check_gltf_extensions(const GltfJson& json, std::vector<std::string>& warnings);

}  // namespace zstrip::sim
