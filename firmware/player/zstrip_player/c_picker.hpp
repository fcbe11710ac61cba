// Gives a program in C the function for zstrip_player_pick. In the file in C++ that has the pipeline:
//     extern "C" const zstrip_picker* scene_picker() {
//       static constexpr zstrip_picker picker{zstrip::pick_with<baked::kEffects>};
//       return &picker;
//     }
#pragma once

#include "zstrip_player.h"
#include "zstrip_player/pick_with.hpp"

/// An argument of zstrip_player_pick.
struct zstrip_picker {
  zstrip::ChoosePick choose;  ///< zstrip::pick_with, with the effects of the pipeline
};
