// Finds materials for which light at vertices would be wrong: large triangles close to a lamp.
#pragma once

#include "import/model.hpp"

namespace zstrip::sim {

/// Largest error of light inside a triangle, relative to full light; above it light is computed at pixels.
inline constexpr double kMaxLightError = 16.0 / 255;

/// Sets smooth materials to Shading::pixel if the point and spot lights on their meshes differ by more than
/// kMaxLightError from the interpolation between the vertices. Compares at the middle of each triangle and of its
/// edges.
void light_at_pixels(Model& model);

}  // namespace zstrip::sim
