// Surfaces that are seen from both sides: the renderer lights a vertex once, whichever side of it is seen.
#pragma once

#include <vector>

#include "import/source_model.hpp"

namespace zstrip::sim {

/// Gives lit meshes of which the file says that they are double-sided a second mesh for their back faces, with normals
/// that face the other way, and makes both single-sided. Not those whose back faces are out of sight: opaque closed
/// bodies, by `closed_outside`, which gets an entry for each new mesh.
void split_sides(SourceModel& model, std::vector<bool>& closed_outside);

}  // namespace zstrip::sim
