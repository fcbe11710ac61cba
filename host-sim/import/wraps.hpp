// Textures that do not repeat: the renderer repeats all, so that others are made to look as they should.
#pragma once

#include "import/source_model.hpp"

namespace zstrip::sim {

/// Mirrored textures are doubled where coordinates reach beyond them. Coordinates of clamped ones are kept from the
/// border; where triangles cross it, small ones get more of it. What is left is repeated, with a warning that names the
/// texture.
void show_wraps(SourceModel& model);

}  // namespace zstrip::sim
