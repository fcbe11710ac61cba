// Where a camera must stand so that a turning model fills the picture.
#pragma once

#include <array>

#include "zstrip/scene.hpp"

namespace zstrip::sim {

/// The turntable camera looks down by this angle, in degrees.
inline constexpr double kTilt = 20;

struct FramingView {
  double aspect = 1;        ///< width / height
  double half_tangent = 1;  ///< tangent of half the vertical field of view
  bool orthographic = false;
  bool whole_turn = false;  ///< every angle about the y axis must fit; else only the model as it stands
};

/// In the scene's units. The eye is at target + distance * (0, sin kTilt, cos kTilt).
struct Framing {
  std::array<double, 3> target{};
  double distance = 1;
  double half_height = 1;  ///< of what is seen; for orthographic cameras
};

/// The closest camera that shows all vertices of the instances, as they stand, with a margin of 5 % a side.
Framing frame_scene(const Scene& scene, const FramingView& view);

/// The largest distance of a vertex from the scene's origin.
double radius_about_origin(const Scene& scene);

}  // namespace zstrip::sim
