// The lights (KHR_lights_punctual) and cameras of a glTF file's scene.
#pragma once

#include "import/gltf/json.hpp"
#include "import/gltf/nodes.hpp"
#include "import/source_model.hpp"

namespace zstrip::sim {

/// Adds a light for each node that has one.
void read_gltf_lights(const GltfJson& json, const GltfNodes& nodes, SourceModel& model);
void read_gltf_cameras(const GltfJson& json, const GltfNodes& nodes, SourceModel& model);

}  // namespace zstrip::sim
