// The rotation that makes an axis of a model point upwards.
#pragma once

#include "import/source_model.hpp"
#include "motion/affine.hpp"

namespace zstrip::sim {

/// Returns the rotation of the axis to +y, by right angles.
Affine turn_up(UpAxis up);

}  // namespace zstrip::sim
