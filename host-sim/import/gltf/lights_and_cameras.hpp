// What lights a glTF file's scene (KHR_lights_punctual) and looks at it.
#pragma once

#include "import/gltf/json.hpp"
#include "import/gltf/nodes.hpp"
#include "import/source_model.hpp"

namespace zstrip::sim {

/// One of each node that has one.
void read_gltf_lights(const GltfJson& json, const GltfNodes& nodes, SourceModel& model);
void read_gltf_cameras(const GltfJson& json, const GltfNodes& nodes, SourceModel& model);

}  // namespace zstrip::sim
