// Converts the file's lights and fog to the scene's units.
#pragma once

#include "compose/composed_scene.hpp"

namespace zstrip::sim {

/// Both functions add to `scene`, whose units must be set. Failures say the line of a value that is out of range.
Result<Done> add_lights(const SceneFile& file, ComposedScene& scene);
Result<Done> add_fog(const SceneFile& file, ComposedScene& scene);

}  // namespace zstrip::sim
