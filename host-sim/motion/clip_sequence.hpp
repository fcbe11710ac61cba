// Joins animations of a model to one: each is shown for some seconds, and fades into the next.
#pragma once

#include <span>

#include "motion/node_tree.hpp"

namespace zstrip::sim {

/// One step of a sequence.
struct ClipStep {
  const NodeAnimation* clip = nullptr;  ///< begins with the step, and again whenever it ends within the step
  double seconds = 1;                   ///< of the step, > 0
  double fade = 0;  ///< seconds at the start of the step during which the clip before, which goes on, becomes this one;
                    ///< 0 to `seconds`
};

/// Returns an animation that lasts as long as all steps together and then begins again: the first step fades from the
/// last one. During a fade each node moves from one clip's placement to the other's, rotations along the shorter arc,
/// as `blend` of zstrip/skin.hpp does, and each weight from one to the other; a weight that a clip does not move is at
/// rest there. It has values 60 times a second, with straight lines between them, and on either side of a step that
/// does not fade. `steps`: not empty; their clips are those of `tree`.
NodeAnimation joined_clips(const NodeTree& tree, std::span<const ClipStep> steps);

}  // namespace zstrip::sim
