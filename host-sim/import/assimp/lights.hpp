// Converts Assimp's lights to those of the source model.
#pragma once

#include <assimp/scene.h>

#include "import/source_model.hpp"

namespace zstrip::sim {

/// `turn` is applied after all nodes. Only directional lights are converted, because formats disagree on the units of
/// others; a warning counts the others.
void read_lights(const aiScene& scene, const aiMatrix4x4& turn, SourceModel& model);

}  // namespace zstrip::sim
