// The checks that a view with several samples adds.
#pragma once

#include "zstrip/budget.hpp"
#include "zstrip/camera.hpp"
#include "zstrip/status.hpp"

namespace zstrip::detail::samples {

/// Checks that the view's samples are supported and that the camera can show them.
Status check_view(const Camera& camera, const View& view);
/// Checks that a plan for RGB565 pixels has a working strip.
Status check_colour(const View& view, const Plan& plan);

}  // namespace zstrip::detail::samples
