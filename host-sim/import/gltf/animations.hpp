// Animations of a glTF file: curves of its nodes. Those of morph targets are left out.
#pragma once

#include <set>

#include "import/gltf/accessors.hpp"
#include "import/gltf/json.hpp"
#include "import/gltf/nodes.hpp"
#include "import/source_model.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// The nodes that some animation of the file moves, turns or grows.
std::set<std::size_t> nodes_of_animations(const GltfJson& json);
/// Whether some animation of the file changes weights of morph targets.
bool animations_morph(const GltfJson& json);

/// Fills `model.nodes.animations`; `nodes` knows which nodes move. The failure's message is a reason.
Result<Done> read_gltf_animations(const GltfJson& json, GltfAccessors& accessors, const GltfNodes& nodes,
                                  SourceModel& model);

}  // namespace zstrip::sim
