// Moves a camera as the user does: around its target, nearer and farther.
#include "view/orbiting.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "motion/affine.hpp"

namespace zstrip::sim {
namespace {

constexpr double kSteepest = 89;        // degrees
constexpr double kFurthestEye = 32767;  // 16.16
constexpr double kAxisOne = 1 << 30;    // 2.30

Vector from_fixed(const Vec3& v, double one) { return {v.x / one, v.y / one, v.z / one}; }

/// Converts to unit length; rounding does not make the vector longer.
Vec3 to_axis(const Vector& v) {
  const double length = std::sqrt(scalar_product(v, v));
  const auto rounded = [&](double value) { return static_cast<Fixed>(std::lround(value / length * kAxisOne)); };
  return {rounded(v[0]), rounded(v[1]), rounded(v[2])};
}

Fixed to_fixed(double value) {
  return static_cast<Fixed>(std::lround(std::clamp(value, -kFurthestEye, kFurthestEye) * kFixedOne));
}

Fixed to_positive_fixed(double value) { return std::max(Fixed{1}, to_fixed(value)); }

double clamped(double value, const OrbitLimits::Range& range) { return std::clamp(value, range.least, range.most); }

/// Returns the distance from the eye to the centre of the rotation.
double distance_to_pivot(const Camera& camera, const Vector& back, const OrbitLimits& limits) {
  if (limits.target > 0) return limits.target;
  const double near_plane = static_cast<double>(camera.near_plane) / kFixedOne;
  const double far_plane = static_cast<double>(camera.far_plane) / kFixedOne;
  const double to_origin = scalar_product(from_fixed(camera.eye, kFixedOne), back);
  return to_origin > 2 * near_plane ? to_origin : std::sqrt(near_plane * far_plane);
}

Vector pivot_of(const Camera& camera, const Vector& back, double distance) {
  Vector pivot = from_fixed(camera.eye, kFixedOne);
  for (std::size_t i = 0; i < 3; ++i) pivot[i] -= distance * back[i];
  return pivot;
}

}  // namespace

Orbiting within_limits(const Camera& camera, Orbiting by, const OrbitLimits& limits) {
  by = {clamped(by.yaw, limits.yaw), clamped(by.pitch, limits.pitch), clamped(by.distance, limits.distance)};
  const Vector back = from_fixed(camera.back, kAxisOne);
  const double elevation = std::asin(std::clamp(back[1], -1.0, 1.0)) * 180 / std::numbers::pi;
  const double steepest = std::max(kSteepest, std::abs(elevation));
  by.pitch = std::clamp(elevation + by.pitch, -steepest, steepest) - elevation;
  // The eye stays in the range of coordinates in every direction.
  const double distance = distance_to_pivot(camera, back, limits);
  double room = kFurthestEye;
  for (const double coordinate : pivot_of(camera, back, distance)) {
    room = std::min(room, kFurthestEye - std::abs(coordinate));
  }
  if (by.distance > 1) by.distance = std::max(1.0, std::min(by.distance, room / distance));
  return by;
}

Camera orbited(const Camera& camera, const Orbiting& unlimited, const OrbitLimits& limits) {
  if (unlimited.yaw == 0 && unlimited.pitch == 0 && unlimited.distance == 1) return camera;
  const Orbiting by = within_limits(camera, unlimited, limits);
  const Vector right = from_fixed(camera.right, kAxisOne), up = from_fixed(camera.up, kAxisOne),
               back = from_fixed(camera.back, kAxisOne);
  const double distance = distance_to_pivot(camera, back, limits);
  const Vector pivot = pivot_of(camera, back, distance);
  // First about the camera's own axis: it is horizontal unless the scene's camera is tilted.
  const Affine turn = rotation(about_axis({0, 1, 0}, -by.yaw)) * rotation(about_axis(right, -by.pitch));

  Camera moved = camera;
  moved.right = to_axis(turn * right);
  moved.up = to_axis(turn * up);
  const Vector new_back = turn * back;
  moved.back = to_axis(new_back);
  const double new_distance = distance * by.distance;
  moved.eye = {to_fixed(pivot[0] + new_distance * new_back[0]), to_fixed(pivot[1] + new_distance * new_back[1]),
               to_fixed(pivot[2] + new_distance * new_back[2])};
  if (camera.projection == Projection::orthographic) {
    moved.focal = to_positive_fixed(static_cast<double>(camera.focal) / kFixedOne / by.distance);
  }
  // Surfaces in front of the far plane stay in front of it; surfaces behind the near plane stay visible when closer.
  const double step = new_distance - distance;
  moved.far_plane = to_positive_fixed(static_cast<double>(camera.far_plane) / kFixedOne + std::max(0.0, step));
  moved.near_plane = to_positive_fixed(static_cast<double>(camera.near_plane) / kFixedOne * std::min(1.0, by.distance));
  return usable(moved) ? moved : camera;
}

}  // namespace zstrip::sim
