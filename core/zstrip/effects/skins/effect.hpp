// Skins that are moved while they are drawn.
#pragma once

#include "zstrip/effects/effect.hpp"

namespace zstrip::detail::skins {

struct Effect : AnyEffect {
  static constexpr EffectName kNames[] = {
      {effect::skins, "skins", "a skin that is moved while it is drawn"},
  };
  static constexpr Exclusion kExclusions[] = {
      {effect::skins, method::any, "methods look at vertices and spheres before they are moved"},
  };
};

}  // namespace zstrip::detail::skins
