// The pipelines of the program that shows baked scenes.
#pragma once

#include "zstrip_player/player.hpp"

namespace zstrip::board {

/// For Player's constructor: what draws any scene, with either projection, that keeps depth as z16 and textures with
/// the usual accuracy. What was baked with other settings is named as missing.
DrawnWith drawn_with_baked(Effects called_for);

}  // namespace zstrip::board
