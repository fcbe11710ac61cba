// Supersampling: several samples a pixel.
#pragma once

#include "zstrip/effects/effect.hpp"

namespace zstrip::detail::samples {

struct Effect : AnyEffect {
  static constexpr EffectName kNames[] = {
      {effect::supersampled, "supersampled", "the picture has several samples a pixel (--samples)"},
  };
};

}  // namespace zstrip::detail::samples
