// What lights a file's scene: Assimp's lights as those of the source model.
#pragma once

#include <assimp/scene.h>

#include "import/source_model.hpp"

namespace zstrip::sim {

/// `turn` comes after all nodes. Only directional ones: formats do not agree on the units of others, which are counted
/// in a warning.
void read_lights(const aiScene& scene, const aiMatrix4x4& turn, SourceModel& model);

}  // namespace zstrip::sim
