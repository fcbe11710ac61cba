// Declared, not there: what code without spheres and ellipsoids may know of their light.
#pragma once

#include "zstrip/effects/quadrics/quadric.hpp"
#include "zstrip/raster/fragment.hpp"

namespace zstrip::detail {

template <Effects effects>
struct QuadricShade;

}  // namespace zstrip::detail
