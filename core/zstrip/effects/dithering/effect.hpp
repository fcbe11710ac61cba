// Dithers pictures that have few colours.
#pragma once

#include "zstrip/effects/effect.hpp"

namespace zstrip::detail::dithering {

struct Effect : AnyEffect {
  static constexpr EffectName kNames[] = {
      {effect::dithered_colours, "dithered_colours", "the picture is dithered to RGB565 (--dither)"},
      {effect::dithered_format, "dithered_format", "the picture is dithered to its format (--dither)"},
  };
};

}  // namespace zstrip::detail::dithering
