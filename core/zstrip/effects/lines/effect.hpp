// Lines and points.
#pragma once

#include "zstrip/effects/effect.hpp"

namespace zstrip::detail::lines {

struct Effect : AnyEffect {
  static constexpr EffectName kNames[] = {
      {effect::lines, "lines", "lines and points"},
  };
  static constexpr Exclusion kExclusions[] = {
      {effect::lines, method::painter, "they are no triangles that could be sorted"},
  };
};

}  // namespace zstrip::detail::lines
