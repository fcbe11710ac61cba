// Sprites and text over the picture.
#pragma once

#include "zstrip/effects/effect.hpp"

namespace zstrip::detail::overlay {

struct Effect : AnyEffect {
  static constexpr EffectName kNames[] = {
      {effect::overlay, "overlay", "the scene has sprites or labels over its picture"},
  };
};

}  // namespace zstrip::detail::overlay
