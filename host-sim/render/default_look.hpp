// The default camera, light and background of a model: seen from three quarters, with a margin, lit from all sides, in
// front of a light background. Scene files, baked scenes and measurements have the plain look, or their own.
#pragma once

#include "zstrip/scene.hpp"
#include "zstrip/view.hpp"
#include "zstrip_scenes/presentation.hpp"

namespace zstrip::sim {

struct DefaultLook {
  double yaw = 0;        ///< degrees that the camera stands to the right of the model's front
  double filled = 0.95;  ///< share of the picture's width or height that the model fills
  Colour background{0, 0, 0, 255};
  DirectionalLight light = scenes::kKeyLight[0];  ///< with `ambient` at most white
  Colour ambient = scenes::kAmbient;
};

/// The model is seen from the front, on a black background.
inline constexpr DefaultLook kPlainLook{};

/// Returns the look for people. With one bit a pixel the background is black: light grey would be as white as the
/// model.
constexpr DefaultLook look_for_people(PixelFormat format) {
  DefaultLook look{.yaw = 30,
                   .filled = 0.9,
                   .background = {206, 211, 214, 255},
                   .light = scenes::light_from(0.1, 0.8, 0.6, {151, 151, 151, 255}),
                   .ambient = {104, 104, 104, 255}};
  if (format == PixelFormat::mono) look.background = kPlainLook.background;
  return look;
}

}  // namespace zstrip::sim
