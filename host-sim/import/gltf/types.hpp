// The types of what a glTF file says: a number where text belongs is damage, not the default.
#pragma once

#include "import/gltf/json.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// Fails where a member that the reader looks at is not of its type. The failure's message is a reason that names it.
Result<Done> check_gltf_types(const GltfJson& json);

}  // namespace zstrip::sim
