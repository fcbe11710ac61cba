// The camera: position, direction and projection of the picture.
#pragma once

#include "zstrip/base/fixed.hpp"
#include "zstrip/status.hpp"

namespace zstrip {

/// Maps points in space to pixels.
enum class Projection : std::uint8_t {
  perspective,   ///< objects that are farther away are smaller
  orthographic,  ///< objects have the same size at any distance; needs effect::orthographic
};

/// Position and axes of the viewer, and the part of space that is in the picture. look_at and orbit set the axes.
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
  Projection projection = Projection::perspective;  ///< selects the meaning of `focal`
  /// True: depth codes span near_plane..far_plane in every frame, so that depths of different frames can be compared.
  /// False: the span is fitted to the depths that each frame's scene can reach, which gives a finer resolution.
  bool fixed_depth_range = false;
};

/// True if a frame can begin with this camera: 0 < near_plane < far_plane, 0 < focal, and no axis is longer than a
/// rounded unit vector. Renderer::begin_frame refuses all other cameras with Error::camera.
bool usable(const Camera& camera);

/// Points the camera from `eye` to `target` (16.16). `up` is a hint of any length; if it is parallel to the viewing
/// direction, look_at uses another axis. Returns Error::camera if eye and target are the same point.
Status look_at(Camera& camera, const Vec3& eye, const Vec3& target, const Vec3& up);

/// Puts the camera on a sphere around `target`: see docs/conventions.md. `radius` in 16.16, > 0; any angles.
Status orbit(Camera& camera, const Vec3& target, Fixed radius, Angle phi, Angle theta);

/// Sets Camera::focal to the cotangent of half the angle, in 16.16. Returns Error::camera unless 0 <
/// vertical_field_of_view < 180 degrees.
Status set_field_of_view(Camera& camera, Angle vertical_field_of_view);

}  // namespace zstrip
