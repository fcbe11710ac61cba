// Measures how far distant parts extend the size of a model.
#pragma once

#include "import/source_model.hpp"

namespace zstrip::sim {

/// Returns the ratio of the model's length to that of the box around the middle half of its corners, for each axis
/// separately. 2 or less for most models; 1 if there is no such box.
double outlying_of(const SourceModel& model);

}  // namespace zstrip::sim
