// Textures that do not repeat: the renderer repeats all textures, so that others are changed to give the same picture.
#pragma once

#include "import/source_model.hpp"

namespace zstrip::sim {

/// Mirrored textures are doubled if coordinates reach beyond them. Coordinates of clamped textures are kept away from
/// the border; if triangles cross it, small textures are extended. Other textures are repeated, with a warning that
/// names the texture.
void show_wraps(SourceModel& model);

}  // namespace zstrip::sim
