// Turns billboards to the camera.
#pragma once

#include "zstrip/scene/camera.hpp"
#include "zstrip/scene/scene.hpp"

namespace zstrip::detail {

/// `transform` with its three axes turned as `billboard` says (docs/conventions.md), each as long as it was, around the
/// same place. Rounded to the nearest 16.16, within 2^-15 of an axis of length 1 and 2^-20 of longer ones' lengths.
Transform turned_to_viewer(const Transform& transform, Billboard billboard, const Camera& camera);

}  // namespace zstrip::detail
