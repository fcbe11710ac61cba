// Effects without a wing: they exist only in the loops of geometry and raster.
#pragma once

#include "zstrip/effects/effect.hpp"

namespace zstrip::detail {

struct EffectsWithoutWing : AnyEffect {
  static constexpr EffectName kNames[] = {
      {effect::lighting, "lighting", "lit, with normals"},
      {effect::gouraud, "gouraud", "smooth shading"},
      {effect::vertex_colours, "vertex_colours", "vertex colours"},
      {effect::textures, "textures", "a texture and texture coordinates"},
      {effect::orthographic, "orthographic", "the camera's parallel projection"},
      {effect::depth_state, "depth_state", "a depth test, depth write or bias of its own"},
      {effect::bins, "bins", "the plan transforms geometry only once (--mode)"},
  };
  static constexpr Exclusion kExclusions[] = {
      {effect::orthographic, effect::depth_float,
       "the small float keeps 1/w, which is the same everywhere without perspective"},
  };
};

}  // namespace zstrip::detail
