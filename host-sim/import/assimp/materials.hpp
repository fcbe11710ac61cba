// Converts Assimp's materials and textures to source materials and decoded pictures.
#pragma once

#include <assimp/scene.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "image/rgb_image.hpp"
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
  /// Sets texture, wrap and alpha. Returns true if the texture has colours.
  bool read_textures(const aiMaterial& from, SourceMaterial& to, unsigned& texcoord_set);
  /// A texture of the model. One without colours is white, with the alpha of a map.
  struct Texture {
    std::uint32_t index = kNoSourceTexture;
    bool has_colours = false;
    AlphaMode alpha_mode = AlphaMode::opaque;  ///< as the map of alpha needs it
  };
  /// Names of pictures, empty for none: colours, and a map whose values become their alpha.
  Texture read_texture(const std::string& colours, const std::string& map, bool inverted);
  /// Returns nothing, with a warning for each name, if the picture cannot be read.
  std::optional<RgbImage> read_picture(const std::string& name, std::string& title);

  const aiScene& scene_;
  std::filesystem::path folder_;
  bool is_blender_fbx_;  ///< Blender wrote metal and roughness as reflection and shininess
  bool linear_;          ///< colours of materials are linear, because Blender wrote them
  bool is_collada_;
  SourceModel& model_;
  std::map<std::tuple<std::string, std::string, bool>, Texture> known_textures_;  ///< also those that failed
  std::set<std::string> unread_pictures_;
  std::vector<unsigned> texcoord_sets_;
};

}  // namespace zstrip::sim
