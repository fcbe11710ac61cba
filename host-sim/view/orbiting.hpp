// A camera that is moved by hand: around what it looks at, nearer and farther.
#pragma once

#include "zstrip/camera.hpp"

namespace zstrip::sim {

struct Orbiting {
  double yaw = 0;       ///< degrees, about the world's y axis; positive turns the scene to the right
  double pitch = 0;     ///< degrees; positive shows more of the scene from above
  double distance = 1;  ///< from what the camera looks at, as a multiple
};

/// The same pitch and distance as far as orbited() follows them: a drag back then moves the camera at once.
Orbiting within_limits(const Camera& camera, Orbiting by);

/// `camera` moved around the point of its axis that is nearest to the world's origin, or, where it stands there itself,
/// a point before it. It never looks steeper than 89 degrees up or down because of `by`. Unmoved it is `camera` itself.
Camera orbited(const Camera& camera, const Orbiting& by);

}  // namespace zstrip::sim
