// The motion of a scene without an animation, over several frames: a rotation by 360 degrees about the world's y axis.
#pragma once

#include <cstdint>

namespace zstrip {

enum class Turning : std::uint8_t {
  instances_and_lines,
  instances,  ///< lines and points do not move
  camera,     ///< the camera moves around the scene, which does not move
  nothing,
};

/// Spheres, ellipsoids and lights never move.
struct Turn {
  Turning what = Turning::instances_and_lines;
  std::uint16_t still_instances = 0;  ///< number of instances at the front of the list that do not move: the instances
                                      ///< of a static layer
  friend constexpr bool operator==(const Turn&, const Turn&) = default;
};

}  // namespace zstrip
