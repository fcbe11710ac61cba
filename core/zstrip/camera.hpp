// The camera: where the picture is taken from, and the two projections.
#pragma once

#include "zstrip/base/fixed.hpp"
#include "zstrip/status.hpp"

namespace zstrip {

/// How points become pixels.
enum class Projection : std::uint8_t {
  perspective,   ///< what is farther is smaller
  orthographic,  ///< as large at any distance; calls for effect::orthographic
};

/// Where the picture is taken from, and what of space is in it. look_at and orbit set the axes.
struct Camera {
  Vec3 right{1 << 30, 0, 0};      ///< 2.30, unit, in world space
  Vec3 up{0, 1 << 30, 0};         ///< 2.30, unit
  Vec3 back{0, 0, 1 << 30};       ///< 2.30, unit, against the viewing direction
  Vec3 eye{0, 0, 3 * kFixedOne};  ///< 16.16, world
  /// 16.16. Perspective: cotangent of half the vertical field of view. Orthographic: 1 / (half the height of the view
  /// in world units).
  Fixed focal = 113512;                             // 16.16: cot(30 degrees)
  Fixed near_plane = 6554;                          ///< 16.16, > 0
  Fixed far_plane = 100 * kFixedOne;                ///< 16.16, > near_plane
  Projection projection = Projection::perspective;  ///< what `focal` means
  /// Depth codes span near_plane..far_plane in every frame, so that depths of different frames can be compared. Else
  /// they are fitted to what each frame's scene can reach, which resolves more.
  bool fixed_depth_range = false;
};

/// Whether a frame can begin with this camera: 0 < near_plane < far_plane, 0 < focal, and no axis longer than a unit
/// vector is when rounded. Renderer::begin_frame refuses all others with Error::camera.
bool usable(const Camera& camera);

/// Points the camera from `eye` to `target` (16.16). `up` is a hint of any length; where it is parallel to the
/// viewing direction another axis is taken. Error::camera if eye and target are the same point.
Status look_at(Camera& camera, const Vec3& eye, const Vec3& target, const Vec3& up);

/// Puts the camera on a sphere around `target`: see docs/conventions.md. `radius` in 16.16, > 0; any angles.
Status orbit(Camera& camera, const Vec3& target, Fixed radius, Angle phi, Angle theta);

/// Cotangent of half the angle, for Camera::focal, in 16.16. 0 < vertical_field_of_view < half a turn, else
/// Error::camera.
Status set_field_of_view(Camera& camera, Angle vertical_field_of_view);

}  // namespace zstrip
