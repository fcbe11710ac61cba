// The function to pass to Player::pick, which finds the surface that a pixel shows.
#pragma once

#include "zstrip/pick.hpp"
#include "zstrip_player/player.hpp"

namespace zstrip {

/// Pass pick_with<effects> to the pick of a player with drawn_with<effects>. Returns null for other effects.
template <Effects effects>
PickFunction pick_with(Effects drawn) {
  if (drawn != effects) return nullptr;
  return &pick<effects>;
}

}  // namespace zstrip
