// Turns billboards to the camera.
#pragma once

#include "zstrip/camera.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::detail {

/// `transform` with its three axes turned for `billboard` (docs/conventions.md), each as long as it was, around the
/// same place. Each entry is within 2^-15 and 2^-19 of the axis' length of what it should be.
Transform turned_to_viewer(const Transform& transform, Billboard billboard, const Camera& camera);

}  // namespace zstrip::detail
