// Detects colours that are linear in light, as programs like Blender write them.
#pragma once

#include <assimp/scene.h>

#include <filesystem>

namespace zstrip::sim {

/// True if the file says that Blender wrote it: its diffuse colours are then linear, and those of other programs are as
/// on the screen. OBJ says it in comments, which plain_mtl reads.
bool has_linear_colours(const aiScene& scene, const std::filesystem::path& path);

}  // namespace zstrip::sim
