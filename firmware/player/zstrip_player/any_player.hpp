// For players of any scene: the player learns a scene's effects when it opens the scene. Meant for hosts, because all
// pipelines are linked (library zstrip::core_any).
#pragma once

#include "zstrip_player/player.hpp"

namespace zstrip {

/// Pass this function to Player's constructor. The player can show text.
inline DrawnWith drawn_with_any(Effects called_for) {
  const Effects effects = called_for | effect::bins | effect::overlay;
  return {effects, pipeline_for(effects)};
}

}  // namespace zstrip
