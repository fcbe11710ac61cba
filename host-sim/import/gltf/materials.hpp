// Materials of a glTF file as source materials.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "import/gltf/json.hpp"
#include "import/gltf/textures.hpp"
#include "import/source_model.hpp"

namespace zstrip::sim {

class GltfMaterials {
 public:
  GltfMaterials(const GltfJson& json, GltfTextures& textures, Highlights highlights, SourceModel& model)
      : json_(json), textures_(textures), highlights_(highlights), model_(model) {}

  /// Fills `model.materials`: the file's in order, then that of what has none.
  void read_all();
  /// The index into `model.materials` of a primitive's.
  std::uint32_t material_of(const GltfJson& primitive) const;
  /// Of this material's texture; of none the first set as it is.
  const GltfTexcoords& texcoords_of(std::uint32_t material) const { return texcoords_[material]; }

 private:
  SourceMaterial read(const GltfJson& from, GltfTexcoords& texcoords);
  /// Sets the emission's colour. Returns its texture, if it has one of its own.
  std::optional<GltfTextureUse> read_emission(const GltfJson& from, const std::optional<GltfTextureUse>& texture,
                                              SourceMaterial& to) const;
  void read_highlight(const GltfJson& from, SourceMaterial& to) const;
  /// Reads both textures where they can be shown together, else what can be.
  GltfTexcoords read_textures(const std::optional<GltfTextureUse>& texture, std::optional<GltfTextureUse> emission,
                              SourceMaterial& to);

  const GltfJson& json_;
  GltfTextures& textures_;
  Highlights highlights_;
  SourceModel& model_;
  std::vector<GltfTexcoords> texcoords_;
};

}  // namespace zstrip::sim
