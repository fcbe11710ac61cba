// Moves a camera as the user does: around its target, nearer and farther.
#pragma once

#include "zstrip/camera.hpp"

namespace zstrip::sim {

struct Orbiting {
  double yaw = 0;       ///< degrees, about the world's y axis; positive rotates the scene to the right
  double pitch = 0;     ///< degrees; positive shows more of the scene from above
  double distance = 1;  ///< factor for the distance from the target
};

/// Limits pitch and distance to the range of orbited(), so that a drag in the other direction moves the camera at once.
Orbiting within_limits(const Camera& camera, Orbiting by);

/// Returns `camera` moved around the point of its axis that is nearest to the world's origin, or, if the camera is at
/// this point, around a point in front of it. `by` never makes the camera look steeper than 89 degrees up or down.
/// Without movement it returns `camera` itself.
Camera orbited(const Camera& camera, const Orbiting& by);

}  // namespace zstrip::sim
