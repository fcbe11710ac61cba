// One of a model file's animations, as a clip of a blob.
#pragma once

#include <string>
#include <vector>

#include "motion/fitted_animation.hpp"
#include "motion/fitted_weights.hpp"
#include "zstrip/clips.hpp"

namespace zstrip::sim {

/// All parts last equally long; at least one of them has tracks.
struct ModelClip {
  std::string name;  ///< may be empty
  FittedAnimation instances, joints;
  FittedWeights weights;            ///< of morph targets
  std::vector<ClipEvent> events{};  ///< with ClipEvent::clip 0; their times ascend
};

}  // namespace zstrip::sim
