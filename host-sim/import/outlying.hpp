// How far what lies apart stretches a model.
#pragma once

#include "import/source_model.hpp"

namespace zstrip::sim {

/// How many times as long the model is as the box around the middle half of its corners, along each axis on its own. 2
/// or less of most models; 1 where there is no such box.
double outlying_of(const SourceModel& model);

}  // namespace zstrip::sim
