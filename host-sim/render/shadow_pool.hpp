// Checks that a shadow's map fits into its pool in all frames that boards show.
#pragma once

#include "render/stage.hpp"
#include "result.hpp"
#include "zstrip/view.hpp"

namespace zstrip::sim {

/// Draws 64 frames of the scene's motion, or one if there is none. Failure: the error that a program would get in one
/// of them.
Result<Done> check_shadow_pool(Stage& stage, const View& view);

}  // namespace zstrip::sim
