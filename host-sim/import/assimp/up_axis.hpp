// The axis of a model that points upwards, by its format.
#pragma once

#include <assimp/scene.h>

#include <filesystem>

#include "import/source_model.hpp"

namespace zstrip::sim {

/// Returns the axis in Assimp's result: Assimp itself rotates some formats (3DS, ASE, DXF, IFC, MD2, MD5, Collada).
UpAxis up_of_format(const aiScene& scene, const std::filesystem::path& path);

}  // namespace zstrip::sim
