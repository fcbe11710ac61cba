// What moves where a scene without an animation is shown over several frames: it makes a full turn about the world's y
// axis.
#pragma once

#include <cstdint>

namespace zstrip {

enum class Turning : std::uint8_t {
  instances_and_lines,
  instances,  ///< lines and points stand still
  camera,     ///< it goes around what stands still
  nothing,
};

/// Spheres, ellipsoids and lights stand still in any case.
struct Turn {
  Turning what = Turning::instances_and_lines;
  std::uint16_t still_instances = 0;  ///< so many, the first ones, stand still: those of a static layer
  friend constexpr bool operator==(const Turn&, const Turn&) = default;
};

}  // namespace zstrip
