// Lines and points.
#pragma once

#include "zstrip/effects/effect.hpp"

namespace zstrip::detail::lines {

struct Effect : AnyEffect {
  static constexpr EffectName kNames[] = {
      {effect::lines, "lines", "lines and points"},
  };
};

}  // namespace zstrip::detail::lines
