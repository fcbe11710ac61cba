// Computes the position of a camera with which a rotating model fills the picture.
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
  bool whole_turn = false;  ///< every angle about the y axis must fit; else only the model in its given orientation
  double yaw = 0;           ///< degrees that the camera stands to the right of the front
  double filled = 0.95;     ///< share of the picture's width or height
};

/// In the scene's units. The eye is at target + distance * (sin yaw cos kTilt, sin kTilt, cos yaw cos kTilt).
struct Framing {
  std::array<double, 3> target{};
  double distance = 1;
  double half_height = 1;  ///< half the visible height; for orthographic cameras
  double yaw = 0;          ///< degrees
};

/// Returns the closest camera that shows all vertices of the instances, as placed, within the share of the picture.
Framing frame_scene(const Scene& scene, const FramingView& view);

/// Returns the largest distance of a vertex from the scene's origin.
double radius_about_origin(const Scene& scene);

}  // namespace zstrip::sim
