// A file's lights in fixed point. Files measure light in physical units, or in none: the exposure is found here.
#pragma once

#include <vector>

#include "import/model.hpp"
#include "import/source_model.hpp"

namespace zstrip::sim {

/// Fills `model.lights` and `model.punctual_lights` with the four of each that are brightest where they meet the model,
/// and adds warnings for those left out. The brightest of all has a channel of full light there: a point or spot light
/// at the model's middle, or half the model's half size away from the light if that is farther.
void set_lights(const std::vector<SourceLight>& lights, const Units& units, Model& model);

}  // namespace zstrip::sim
