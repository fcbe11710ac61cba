// Converts a file's lights to fixed point. Files measure light in physical units, or in none, so that this chooses the
// exposure.
#pragma once

#include <vector>

#include "import/model.hpp"
#include "import/source_model.hpp"

namespace zstrip::sim {

/// Sets `model.lights` and `model.punctual_lights` to the four lights of each kind that are brightest at the model, and
/// adds warnings for the others. The brightest light has a channel of full light there. For a point or spot light, this
/// is at the model's middle, or at a distance of half the model's half size from the light if that is farther.
void set_lights(const std::vector<SourceLight>& lights, const Units& units, Model& model);

}  // namespace zstrip::sim
