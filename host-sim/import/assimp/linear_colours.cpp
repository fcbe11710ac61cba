// Detects colours that are linear in light, as programs like Blender write them.
#include "import/assimp/linear_colours.hpp"

#include <assimp/commonMetaData.h>
#include <assimp/metadata.h>

#include <string_view>

#include "import/ending.hpp"

namespace zstrip::sim {

bool has_linear_colours(const aiScene& scene, const std::filesystem::path& path) {
  if (ending_of(path) == ".blend") return true;
  if (scene.mMetaData == nullptr) return false;
  // FBX and Collada; X3D.
  for (const char* key : {AI_METADATA_SOURCE_GENERATOR, "generator"}) {
    aiString program;
    if (scene.mMetaData->Get(key, program) && std::string_view(program.C_Str()).starts_with("Blender")) return true;
  }
  return false;
}

}  // namespace zstrip::sim
