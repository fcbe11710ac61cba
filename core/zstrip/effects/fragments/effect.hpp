// Alpha, and the selection of texels, fragment by fragment.
#pragma once

#include "zstrip/effects/effect.hpp"

namespace zstrip::detail::fragments {

struct Effect : AnyEffect {
  static constexpr EffectName kNames[] = {
      {effect::alpha_test, "alpha_test", "the alpha mode mask"},
      {effect::texture_alpha, "texture_alpha", "a texture with alpha, masked or blended"},
      {effect::texture_palettes, "texture_palettes", "a texture with a palette"},
      {effect::mipmaps, "mipmaps", "a texture with mipmaps, and a finish"},
      {effect::bilinear, "bilinear", "the texture filter bilinear"},
  };
};

}  // namespace zstrip::detail::fragments
