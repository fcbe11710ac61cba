// Rotates billboards towards the camera.
#pragma once

#include "zstrip/camera.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::detail {

/// Returns `transform` with its three axes rotated for `billboard` (docs/conventions.md), each with its old length,
/// around the same position. The error of an entry is below 2^-15 plus 2^-19 of the axis's length.
Transform turned_to_viewer(const Transform& transform, Billboard billboard, const Camera& camera);

}  // namespace zstrip::detail
