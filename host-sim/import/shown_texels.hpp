// Applies colours that the renderer ignores for unlit textured materials: the material's and the vertices' colours.
#pragma once

#include "import/source_model.hpp"

namespace zstrip::sim {

/// Multiplies an unlit material's colour, and vertex colours that are all equal, into a copy of its texels. If vertex
/// colours differ, the material becomes lit and only emits light: the renderer multiplies its texels by both colours.
void multiply_unlit_texels(SourceModel& model);

}  // namespace zstrip::sim
