// Tells if a built-in scene stays in front of the camera at every angle of the turntable, so that its frames need no
// clipping. Only the compiler runs this code: no floating point reaches a target.
#pragma once

#include <algorithm>
#include <cstdint>

#include "zstrip/view.hpp"
#include "zstrip_scenes/built_in.hpp"

namespace zstrip::scenes {

/// Returns the squared radius of the ball around the world's origin that holds the boxes of all instances. Rotation
/// about the y axis keeps every instance inside.
constexpr double squared_radius(const Scene& scene) {
  double largest = 0;
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    for (int corner = 0; corner < 8; ++corner) {
      const auto side = [corner](int axis, Fixed centre, Fixed half) {
        return centre + ((corner >> axis & 1) != 0 ? 1.0 : -1.0) * half;
      };
      const double p[3] = {side(0, mesh.centre.x, mesh.half_extent.x), side(1, mesh.centre.y, mesh.half_extent.y),
                           side(2, mesh.centre.z, mesh.half_extent.z)};
      double square = 0;
      for (const Fixed(&row)[4] : instance.transform.m) {
        const double c = ((row[0] * p[0] + row[1] * p[1] + row[2] * p[2]) / kFixedOne + row[3]) / kFixedOne;
        square += c * c;
      }
      largest = std::max(largest, square);
    }
  }
  return largest;
}

/// Returns the radius of the largest ball around the world's origin that a renderer with effect::unclipped can draw.
constexpr double radius_in_front(const Camera& camera, const View& view) {
  constexpr double kPixels = 1000;                  // from the picture's centre
  constexpr double kTimes = 32;                     // how many times as far away as the near side the far side may be
  const auto along = [&camera](const Vec3& axis) {  // the eye's coordinate along an axis
    const auto times = [](Fixed a, Fixed b) { return static_cast<double>(a) * b / (1 << 30) / kFixedOne; };
    return times(axis.x, camera.eye.x) + times(axis.y, camera.eye.y) + times(axis.z, camera.eye.z);
  };
  const auto size = [](double value) { return value < 0 ? -value : value; };
  const double distance = along(camera.back);
  const double aside = std::max(size(along(camera.right)), size(along(camera.up)));
  const double of_near = distance - static_cast<double>(camera.near_plane) / kFixedOne;
  const double of_far = static_cast<double>(camera.far_plane) / kFixedOne - distance;
  const double of_times = distance * (kTimes - 1) / (kTimes + 1);
  // (radius + aside) * scale <= kPixels * (distance - radius), parallel <= kPixels. Samples lie closer than pixels.
  const double scale = static_cast<double>(camera.focal) / kFixedOne * view.height / 2 * view.samples;
  const double of_pixels = camera.projection == Projection::orthographic
                               ? kPixels / scale - aside
                               : (kPixels * distance - scale * aside) / (scale + kPixels);
  return std::min({of_near, of_far, of_times, of_pixels});
}

/// True if a renderer with effect::unclipped can draw all frames that stage() makes for this picture; stage() may use
/// a shorter focal length. The test adds a tenth to the ball's radius. False does not prove that clipping is needed.
constexpr bool stays_in_front(const BuiltIn& built_in, const View& view) {
  constexpr double kRoom = 1.1;
  const double largest = radius_in_front(built_in.camera, view);
  return largest > 0 && squared_radius(built_in.scene) * kRoom * kRoom < largest * largest;
}

}  // namespace zstrip::scenes
