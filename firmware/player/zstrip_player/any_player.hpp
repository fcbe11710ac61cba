// For players of any scene, which learn its effects when it is opened: on hosts, because all pipelines are linked
// (library zstrip::core_any).
#pragma once

#include "zstrip_player/player.hpp"

namespace zstrip {

/// For Player's constructor. Text can be shown.
inline DrawnWith drawn_with_any(Effects called_for) {
  const Effects effects = called_for | effect::bins | effect::overlay;
  return {effects, pipeline_for(effects)};
}

}  // namespace zstrip
