// What the renderer leaves out of unlit textured materials: their colour, and the vertices', times the texels.
#pragma once

#include "import/source_model.hpp"

namespace zstrip::sim {

/// Multiplies an unlit material's colour, and vertex colours that are all the same, into texels of its own; where
/// vertex colours differ, the material becomes a lit one that only emits, which is multiplied with both.
void multiply_unlit_texels(SourceModel& model);

}  // namespace zstrip::sim
