// Which axis of a model points upwards, by its format.
#pragma once

#include <assimp/scene.h>

#include <filesystem>

#include "import/source_model.hpp"

namespace zstrip::sim {

/// Of what Assimp has read: it turns some formats itself (3DS, ASE, DXF, IFC, MD2, MD5, Collada), others not.
UpAxis up_of_format(const aiScene& scene, const std::filesystem::path& path);

}  // namespace zstrip::sim
