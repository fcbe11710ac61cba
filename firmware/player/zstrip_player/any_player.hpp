// Pipelines for players of any scene, which learn a scene's effects when they open it. Meant for hosts, because all
// pipelines are linked (library zstrip::core_any).
#pragma once

#include "zstrip/pick.hpp"
#include "zstrip_player/player.hpp"

namespace zstrip {

/// Pass this function to Player's constructor. The player can show text.
inline DrawnWith drawn_with_any(Effects called_for) {
  const Effects effects = called_for | effect::bins | effect::overlay;
  return {effects, pipeline_for(effects)};
}

/// Pass this function to Player::pick of such a player.
inline PickFunction pick_with_any(Effects drawn) { return picker_for(drawn); }

}  // namespace zstrip
