// A stage that adds levels of detail to the meshes of its scene.
#pragma once

#include <memory>

#include "render/stage.hpp"

namespace zstrip::sim {

/// The largest error of a level of detail where it is drawn, by the simplifier's measure.
inline constexpr double kLevelPixels = 0.5;

/// Adds levels to all meshes that do not bend, have no outline and are no operand of CSG. A level begins at the
/// distance from which its error is at most kLevelPixels in pictures of `view` with the stage's camera. Fails if the
/// stage cannot be placed; a usage error with an orthographic camera, to which all distances look the same. Nothing
/// changes if the scene has levels.
Result<std::unique_ptr<Stage>> with_levels(std::unique_ptr<Stage> stage, const View& view);

}  // namespace zstrip::sim
