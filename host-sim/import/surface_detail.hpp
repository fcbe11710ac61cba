// Normal and occlusion maps: the renderer has neither, so their light and shade is painted into the texels.
#pragma once

#include <cstddef>

#include "import/source_model.hpp"

namespace zstrip::sim {

/// Multiplies each texel of a lit material with a normal or an occlusion map by the light that falls on it with the
/// map, divided by the light without. Both are means over all triangles that show the texel. The light is that of the
/// model's directional lights, otherwise the default light of models; an occlusion map dims only light from all sides.
/// No texture becomes larger, and none is added. The textures of the maps become empty. Call it before any step that
/// changes textures or texture coordinates. Returns the number of textures that changed.
std::size_t paint_surface_detail(SourceModel& model);

}  // namespace zstrip::sim
