// Sprites and labels of a composed scene.
#pragma once

#include "compose/composed_scene.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// Adds the scene file's sprites and labels, with their images and fonts. Failures say the line of a [[sprite]].
Result<Done> add_overlay(const SceneFile& file, ComposedScene& scene);

}  // namespace zstrip::sim
