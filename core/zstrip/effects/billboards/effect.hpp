// Billboards rotate with the camera.
#pragma once

#include "zstrip/effects/effect.hpp"

namespace zstrip::detail::billboards {

struct Effect : AnyEffect {
  static constexpr EffectName kNames[] = {
      {effect::billboards, "billboards", "turns with the camera"},
  };
};

}  // namespace zstrip::detail::billboards
