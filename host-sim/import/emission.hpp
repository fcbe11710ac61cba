// Emission with a texture of its own: the renderer has one texture for light and emission.
#pragma once

#include "import/source_model.hpp"

namespace zstrip::sim {

/// Where nothing else of a material is seen, its emission's texture becomes its texture. Else it is added to the
/// texels, and so lit like these, with a warning.
void show_emission(SourceModel& model);

}  // namespace zstrip::sim
