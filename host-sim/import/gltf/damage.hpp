// Damage of a glTF file that leaves a picture: words and indices that stand for nothing.
#pragma once

#include <string>
#include <vector>

#include "import/gltf/json.hpp"

namespace zstrip::sim {

/// Adds a warning for each kind of damage that the readers replace by a default.
void warn_of_gltf_damage(const GltfJson& json, std::vector<std::string>& warnings);

}  // namespace zstrip::sim
