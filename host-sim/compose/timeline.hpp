// The duration and the key times of a scene file's animation.
#pragma once

#include <set>
#include <span>

#include "compose/placed_part.hpp"

namespace zstrip::sim {

/// Returns seconds: the file's duration, or else that of its longest animation.
double duration_of(const SceneFile& file, std::span<const PlacedPart> placed);

/// Returns the times at which motions may bend or jump. `models`: in the order of file.models.
std::set<double> all_key_times(const SceneFile& file, std::span<const PlacedModel> models, double duration);

}  // namespace zstrip::sim
