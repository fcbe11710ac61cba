// The turntable's camera and the light of lit built-in scenes.
#pragma once

#include <cstdint>

#include "zstrip/camera.hpp"
#include "zstrip/scene.hpp"
#include "zstrip_scenes/compile_time.hpp"

namespace zstrip::scenes {

/// Returns a camera `distance` from the origin (world units), `tilt` degrees above its horizon, looking at the origin.
consteval Camera turntable_camera(double distance, double tilt, double focal) {
  const double angle = tilt * compile_time::kPi / 180;
  const double sine = compile_time::sine(angle), cosine = compile_time::cosine(angle);
  constexpr double kUnit = 1 << 30;
  Camera camera;
  camera.right = {1 << 30, 0, 0};
  camera.up = {0, compile_time::nearest(kUnit * cosine), compile_time::nearest(-kUnit * sine)};   // 2.30
  camera.back = {0, compile_time::nearest(kUnit * sine), compile_time::nearest(kUnit * cosine)};  // 2.30
  camera.eye = {0, fixed(distance * sine), fixed(distance * cosine)};                             // 16.16
  camera.focal = fixed(focal);
  return camera;
}

/// Returns a light from the direction (x, y, z), in world units of any length.
consteval DirectionalLight light_from(double x, double y, double z, Colour colour) {
  const double scale = 32767 / compile_time::square_root(x * x + y * y + z * z);  // 1.15
  return {static_cast<std::int16_t>(compile_time::nearest(x * scale)),
          static_cast<std::int16_t>(compile_time::nearest(y * scale)),
          static_cast<std::int16_t>(compile_time::nearest(z * scale)), colour};
}

/// The light comes from the upper left behind the camera. Together with kAmbient it just reaches white.
inline constexpr DirectionalLight kKeyLight[] = {light_from(-0.5, 0.7, 0.6, {207, 207, 207, 255})};
inline constexpr Colour kAmbient{48, 48, 48, 255};

}  // namespace zstrip::scenes
