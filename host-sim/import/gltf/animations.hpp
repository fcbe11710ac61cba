// Animations of a glTF file: curves of its nodes. Animations of morph targets are left out.
#pragma once

#include <cstddef>
#include <map>

#include "import/gltf/accessors.hpp"
#include "import/gltf/json.hpp"
#include "import/gltf/nodes.hpp"
#include "import/source_model.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// Returns the nodes that an animation of the file moves, rotates or scales, each with the largest scale of all
/// animations along each axis; 0: none scales it.
std::map<std::size_t, Vector> nodes_of_animations(const GltfJson& json, GltfAccessors& accessors);
/// True if an animation of the file changes weights of morph targets.
bool animations_morph(const GltfJson& json);

/// Sets `model.nodes.animations`; `nodes` knows the moving nodes. The failure's message is a reason.
Result<Done> read_gltf_animations(const GltfJson& json, GltfAccessors& accessors, const GltfNodes& nodes,
                                  SourceModel& model);

}  // namespace zstrip::sim
