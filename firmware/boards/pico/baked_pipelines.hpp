// The pipelines of the program that shows baked scenes.
#pragma once

#include "zstrip_player/player.hpp"

namespace zstrip::board {

/// For Player's constructor: returns a pipeline for any scene with either projection that keeps depth as z16 and
/// textures with the default accuracy. Other settings of a baked scene are reported as missing.
DrawnWith drawn_with_baked(Effects called_for);

}  // namespace zstrip::board
