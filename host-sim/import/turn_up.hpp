// The rotation that turns an axis of a model upwards.
#pragma once

#include "import/source_model.hpp"
#include "motion/affine.hpp"

namespace zstrip::sim {

/// Turns the axis to +y, by right angles.
Affine turn_up(UpAxis up);

}  // namespace zstrip::sim
