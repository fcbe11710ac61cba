// Replaces textures by colours of vertices, which need no flash for texels and no time for reading them.
#pragma once

#include "import/reduction.hpp"
#include "import/source_model.hpp"

namespace zstrip::sim {

/// Gives the vertices of meshes with an opaque texture the colours of that texture, and removes it: each vertex gets
/// the mean, in linear light, of the texels around it on its triangles. Details between vertices are lost. Textures
/// with alpha and environment maps stay. The record's texels are those of all textures that were removed.
Shrunk fold_textures(SourceModel& model);

}  // namespace zstrip::sim
