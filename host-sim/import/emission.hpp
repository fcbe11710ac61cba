// Materials with a separate texture for emission: the renderer has one texture for light and emission.
#pragma once

#include "import/source_model.hpp"

namespace zstrip::sim {

/// If only a material's emission is visible, its emission's texture becomes its texture. Otherwise the emission is
/// added to the texels. Triangles that glow more than they reflect become unlit; others are lit like their texels, with
/// a warning if they glow visibly.
void show_emission(SourceModel& model);

}  // namespace zstrip::sim
