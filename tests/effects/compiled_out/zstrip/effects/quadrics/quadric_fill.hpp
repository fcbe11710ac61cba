// Declared, not there: what code without spheres and ellipsoids may know of them.
#pragma once

#include "zstrip/effects/quadrics/quadric.hpp"
#include "zstrip/pixels/depth_rule.hpp"

namespace zstrip::detail {

template <Effects effects>
class QuadricFill;

}  // namespace zstrip::detail
