// Quadrics: spheres and ellipsoids without triangles.
#pragma once

#include "zstrip/effects/effect.hpp"

namespace zstrip::detail::quadrics {

struct Effect : AnyEffect {
  static constexpr EffectName kNames[] = {
      {effect::quadrics, "quadrics", "spheres and ellipsoids"},
  };
  static constexpr Exclusion kExclusions[] = {
      {effect::quadrics, method::painter, "they are no triangles that could be sorted"},
  };
};

}  // namespace zstrip::detail::quadrics
