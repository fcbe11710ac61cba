// Surfaces that are seen from both sides: the renderer lights a vertex once, whichever side of it is seen.
#pragma once

#include <vector>

#include "import/source_model.hpp"
#include "import/surface.hpp"

namespace zstrip::sim {

/// What a file says nothing of is double-sided where its openings are at least this share of its area: sheets and
/// bowls. Back faces of a house without a floor are hardly seen, and not worth twice the triangles.
inline constexpr double kMinOpening = 1.0 / 3;

/// Gives lit meshes that are double-sided a second mesh for their back faces, with normals that face the other way, and
/// makes both single-sided. Not those whose back faces are out of sight: opaque closed bodies. `outsides`: of each
/// mesh; gets an entry for each new one.
void split_sides(SourceModel& model, std::vector<Outside>& outsides);

}  // namespace zstrip::sim
