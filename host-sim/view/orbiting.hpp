// Moves a camera as the user does: around its target, nearer and farther.
#pragma once

#include "render/orbit_limits.hpp"
#include "zstrip/camera.hpp"

namespace zstrip::sim {

struct Orbiting {
  double yaw = 0;       ///< degrees, about the world's y axis; positive rotates the scene to the right
  double pitch = 0;     ///< degrees; positive shows more of the scene from above
  double distance = 1;  ///< factor for the distance from the target
};

/// Returns the movement within `limits` and the range of orbited(), so that a drag in the other direction moves the
/// camera at once.
Orbiting within_limits(const Camera& camera, Orbiting by, const OrbitLimits& limits = {});

/// Returns `camera` moved around the target of `limits`. Without one it is the point of the camera's axis that is
/// nearest to the world's origin, or, if the camera is at this point, a point in front of it. `by` never makes the
/// camera look steeper than 89 degrees up or down. Without movement it returns `camera` itself.
Camera orbited(const Camera& camera, const Orbiting& by, const OrbitLimits& limits = {});

}  // namespace zstrip::sim
