// Finds out if a baked scene needs no clipping: begins each pose of the scene's own motion with a renderer that has
// none.
#pragma once

#include <cstdint>
#include <string>

#include "bake/baked_scene.hpp"

namespace zstrip::sim {

/// The clipping of a header's kEffects.
struct ClippingRecord {
  bool left_out = false;    ///< kEffects has effect::unclipped
  std::uint32_t poses = 0;  ///< number of poses that were checked
  std::string where;        ///< if it is left out, the poses: "in any pose of a rotation"
  std::string why;          ///< if clipping stays: the instance and pose that need it, or why nothing was checked
};

/// Checks the poses of the scene's motion: each millisecond of its animation, or with `turntable` each angle of a
/// rotation. With many instances fewer poses are checked, and those of a rotation with room for the poses between them.
/// `baked`: with all effects except effect::unclipped.
ClippingRecord find_clipping(const BakedScene& baked, bool turntable);

}  // namespace zstrip::sim
