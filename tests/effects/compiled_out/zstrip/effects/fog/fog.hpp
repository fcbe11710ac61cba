// Declared, not there: what code without fog may know of it.
#pragma once

#include "zstrip/geometry/distance.hpp"
#include "zstrip/pixels/plane.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::detail {

struct FogCurve {
  alignas(8) char unused[40];
};
FogCurve fog_curve(const Fog& fog, const DistanceScale& distance);
template <bool orthographic>
class FogPlane;

}  // namespace zstrip::detail
