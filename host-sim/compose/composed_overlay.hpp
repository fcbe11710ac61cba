// Sprites and labels of a composed scene.
#pragma once

#include "compose/composed_scene.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// Adds those of the scene file, with images that they name and fonts. Failures name the line of a [[sprite]].
Result<Done> add_overlay(const SceneFile& file, ComposedScene& scene);

}  // namespace zstrip::sim
