// The types of a glTF file's members: a number in place of text is an error, and does not become the default.
#pragma once

#include "import/gltf/json.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// Fails if a member that the reader uses has a wrong type. The failure's message is a reason that names it.
Result<Done> check_gltf_types(const GltfJson& json);

}  // namespace zstrip::sim
