// The checks that a view with several samples adds.
#pragma once

#include "zstrip/budget.hpp"
#include "zstrip/camera.hpp"
#include "zstrip/status.hpp"

namespace zstrip::detail::samples {

/// Whether a view can have its samples, and a camera show them.
Status check_view(const Camera& camera, const View& view);
/// A plan for pixels of RGB565 has no working strip.
Status check_colour(const View& view, const Plan& plan);

}  // namespace zstrip::detail::samples
