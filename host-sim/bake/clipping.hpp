// Whether a baked scene can do without clipping: each pose that its own motion has is begun with a renderer that has
// none.
#pragma once

#include <cstdint>
#include <string>

#include "bake/baked_scene.hpp"

namespace zstrip::sim {

/// Of a header's kEffects.
struct ClippingRecord {
  bool left_out = false;    ///< they have effect::unclipped
  std::uint32_t poses = 0;  ///< that were checked
  std::string where;        ///< those, if it is left out: "in any pose of a turn"
  std::string why;          ///< where clipping stays: what in which pose calls for it, or why nothing was checked
};

/// Checks the poses of the scene's motion: each millisecond of its animation, or with `turntable` each angle that a
/// turn has. Fewer where there are many instances, of a turn with room for the poses between.
/// `baked`: with all effects but this one.
ClippingRecord find_clipping(const BakedScene& baked, bool turntable);

}  // namespace zstrip::sim
