// Surfaces that can be seen from both sides: the renderer lights a vertex once, for either side.
#pragma once

#include <vector>

#include "import/source_model.hpp"
#include "import/surface.hpp"

namespace zstrip::sim {

/// If a file does not say it, a surface is double-sided if its openings are at least this share of its area: sheets and
/// bowls. Back faces of a house without a floor are hardly visible, and not worth twice the triangles.
inline constexpr double kMinOpening = 1.0 / 3;

/// Gives lit double-sided meshes a second mesh for their back faces, with normals in the other direction, and makes
/// both single-sided. Excludes meshes whose back faces are not visible: opaque closed bodies. `outsides`: one for each
/// mesh; gets an entry for each new mesh.
void split_sides(SourceModel& model, std::vector<Outside>& outsides);

}  // namespace zstrip::sim
