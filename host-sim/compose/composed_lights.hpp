// Lights and fog of a composed scene: the file's, in the scene's units.
#pragma once

#include "compose/composed_scene.hpp"

namespace zstrip::sim {

/// Both add to `scene`, whose units are set. Failures name the line of what does not fit them.
Result<Done> add_lights(const SceneFile& file, ComposedScene& scene);
Result<Done> add_fog(const SceneFile& file, ComposedScene& scene);

}  // namespace zstrip::sim
