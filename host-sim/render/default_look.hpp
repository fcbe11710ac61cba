// How a model is shown that says nothing about it: seen from three quarters, with a margin, lit from all sides, in
// front of a light background. Scene files, baked scenes and measurements have the plain look, or one of their own.
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

/// Frontal, in front of black.
inline constexpr DefaultLook kPlainLook{};

/// For people. `format`: one bit has no light grey, and a lit model would be as white as its background.
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
