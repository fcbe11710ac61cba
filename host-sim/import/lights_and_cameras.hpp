// Lights and cameras of a file's scene: Assimp's as those of the source model.
#pragma once

#include <assimp/scene.h>

#include "import/source_model.hpp"

namespace zstrip::sim {

/// `turn` comes after all nodes. Point and spot lights only where the file is `gltf` 2.0, whose units are those of
/// KHR_lights_punctual; others are counted in a warning.
void read_lights(const aiScene& scene, const aiMatrix4x4& turn, bool gltf, SourceModel& model);

/// Cameras of glTF 2.0; other formats do not agree what their angles mean.
void read_cameras(const aiScene& scene, const aiMatrix4x4& turn, SourceModel& model);

}  // namespace zstrip::sim
