// Computes light at each pixel.
#pragma once

#include "zstrip/effects/effect.hpp"

namespace zstrip::detail::pixel_shading {

struct Effect : AnyEffect {
  static constexpr EffectName kNames[] = {
      {effect::pixel_shading, "pixel_shading", "lit at pixels, with normals"},
  };
};

}  // namespace zstrip::detail::pixel_shading
