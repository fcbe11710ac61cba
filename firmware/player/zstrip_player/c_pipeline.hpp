// Gives a program in C its pipeline. In one file in C++:
//     #include "scene.hpp"  // zstrip bake model.glb -o scene.hpp --clipping on
//     extern "C" const zstrip_pipeline* scene_pipeline() {
//       static constexpr zstrip_pipeline pipeline{zstrip::drawn_with<baked::kEffects>};
//       return &pipeline;
//     }
#pragma once

#include "zstrip_player.h"
#include "zstrip_player/player.hpp"

/// The argument of zstrip_player_in; it must live as long as the player.
struct zstrip_pipeline {
  zstrip::ChoosePipeline choose;  ///< zstrip::drawn_with
};
