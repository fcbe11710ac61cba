// Skins whose vertices are moved while they are drawn.
#pragma once

#include "zstrip/effects/effect.hpp"

namespace zstrip::detail::skins {

struct Effect : AnyEffect {
  static constexpr EffectName kNames[] = {
      {effect::skins, "skins", "a skin that is moved while it is drawn"},
  };
};

}  // namespace zstrip::detail::skins
