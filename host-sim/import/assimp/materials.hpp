// Converts Assimp's materials and textures to source materials and decoded pictures.
#pragma once

#include <assimp/scene.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "import/source_model.hpp"

namespace zstrip::sim {

/// Sets `model.materials` (one for each of the scene's, same index) and `model.textures`, and adds warnings for
/// textures that cannot be read. Texture files are searched next to the model.
class MaterialReader {
 public:
  MaterialReader(const aiScene& scene, const std::filesystem::path& path, SourceModel& model);
  void read_all();

  /// Returns the set of texture coordinates that the material's texture uses.
  unsigned texcoord_set(unsigned material) const { return texcoord_sets_[material]; }

 private:
  SourceMaterial read(const aiMaterial& from, unsigned& texcoord_set);
  /// Sets metal and roughness; without them the material is not a metal.
  void read_metal(const aiMaterial& from, SourceMaterial& to) const;
  std::uint32_t read_texture(const std::string& name);

  const aiScene& scene_;
  std::filesystem::path folder_;
  bool is_blender_fbx_;  ///< Blender wrote metal and roughness as reflection and shininess
  bool linear_;          ///< colours of materials are linear, because Blender wrote them
  SourceModel& model_;
  std::map<std::string, std::uint32_t> known_textures_;  ///< by name; also those that failed
  std::vector<unsigned> texcoord_sets_;
};

}  // namespace zstrip::sim
