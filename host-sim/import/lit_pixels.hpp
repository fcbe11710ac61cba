// Where light at vertices would be wrong: large triangles beside a lamp.
#pragma once

#include "import/model.hpp"

namespace zstrip::sim {

/// The most that light may be off inside a triangle, of full light, before it is computed at pixels.
inline constexpr double kMaxLightError = 16.0 / 255;

/// Smooth materials of meshes whose point and spot lights differ by more than kMaxLightError from what lies between the
/// vertices become Shading::pixel. Looks at the middle of each triangle and of its edges.
void light_at_pixels(Model& model);

}  // namespace zstrip::sim
