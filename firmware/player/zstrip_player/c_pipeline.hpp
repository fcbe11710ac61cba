// The pipeline of a program in C. In one file in C++:
//     #include "scene.hpp"
//     extern "C" const zstrip_pipeline* scene_pipeline() {
//       static constexpr zstrip_pipeline pipeline{zstrip::drawn_with<baked::kEffects>};
//       return &pipeline;
//     }
#pragma once

#include "zstrip_player.h"
#include "zstrip_player/player.hpp"

/// What zstrip_player_in gets from C++; as long as the player lives.
struct zstrip_pipeline {
  zstrip::ChoosePipeline choose;  ///< zstrip::drawn_with
};
