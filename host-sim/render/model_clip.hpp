// One of a model file's animations, as a clip of a blob.
#pragma once

#include <string>

#include "motion/fitted_animation.hpp"

namespace zstrip::sim {

/// Both parts last equally long; at least one of them has tracks.
struct ModelClip {
  std::string name;  ///< may be empty
  FittedAnimation instances, joints;
};

}  // namespace zstrip::sim
