// Animations of a glTF file: curves of its nodes and of weights of morph targets.
#pragma once

#include <cstddef>
#include <map>

#include "import/gltf/accessors.hpp"
#include "import/gltf/json.hpp"
#include "import/gltf/morphs.hpp"
#include "import/gltf/nodes.hpp"
#include "import/source_model.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// Returns the nodes that an animation of the file moves, rotates or scales, each with the largest scale of all
/// animations along each axis; 0: none scales it.
std::map<std::size_t, Vector> nodes_of_animations(const GltfJson& json, GltfAccessors& accessors);

/// Sets `model.nodes.animations` and `model.weights`; `nodes` knows the moving nodes, `morphs` then the moving targets.
/// The failure's message is a reason.
Result<Done> read_gltf_animations(const GltfJson& json, GltfAccessors& accessors, const GltfNodes& nodes,
                                  GltfMorphs& morphs, SourceModel& model);

}  // namespace zstrip::sim
