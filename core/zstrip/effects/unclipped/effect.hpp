// A promise that no triangle reaches the near plane or leaves the narrow range, so that clipping is left out.
#pragma once

#include "zstrip/effects/effect.hpp"

namespace zstrip::detail::unclipped {

struct Effect : AnyEffect {
  static constexpr EffectName kNames[] = {
      {effect::unclipped, "unclipped", "nothing comes near the camera: no clipping (a turntable)"},
  };
  static constexpr Exclusion kExclusions[] = {
      {effect::unclipped, effect::outlines, "hulls reach beyond the boxes of their instances"},
      {effect::unclipped, effect::shadows, "a shadow map has triangles beyond the picture"},
  };
};

}  // namespace zstrip::detail::unclipped
