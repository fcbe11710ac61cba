// When things happen in a scene file's animation.
#pragma once

#include <set>
#include <span>

#include "compose/placed_part.hpp"

namespace zstrip::sim {

/// Seconds: as in the file, or else its longest animation.
double duration_of(const SceneFile& file, std::span<const PlacedPart> placed);

/// When motions may bend or jump. `models`: of file.models.
std::set<double> all_key_times(const SceneFile& file, std::span<const PlacedModel> models, double duration);

}  // namespace zstrip::sim
