// Quadrics: spheres and ellipsoids without triangles.
#pragma once

#include "zstrip/effects/effect.hpp"

namespace zstrip::detail::quadrics {

struct Effect : AnyEffect {
  static constexpr EffectName kNames[] = {
      {effect::quadrics, "quadrics", "spheres and ellipsoids"},
  };
};

}  // namespace zstrip::detail::quadrics
