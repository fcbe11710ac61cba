// Converts materials of a glTF file to source materials.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "import/gltf/json.hpp"
#include "import/gltf/textures.hpp"
#include "import/source_model.hpp"

namespace zstrip::sim {

class GltfMaterials {
 public:
  GltfMaterials(const GltfJson& json, GltfTextures& textures, Shine shine, SourceModel& model)
      : json_(json), textures_(textures), shine_(shine), model_(model) {}

  /// Sets `model.materials`: the file's in order, then the material of primitives without one.
  void read_all();
  /// Returns the index into `model.materials` of a primitive's material.
  std::uint32_t material_of(const GltfJson& primitive) const;
  /// Returns the map of this material's texture; without a texture the first set, unchanged.
  const GltfTexcoords& texcoords_of(std::uint32_t material) const { return texcoords_[material]; }

 private:
  SourceMaterial read(const GltfJson& from, GltfTexcoords& texcoords);
  /// Sets the emission's colour. Returns its texture, if it has a separate one.
  std::optional<GltfTextureUse> read_emission(const GltfJson& from, const std::optional<GltfTextureUse>& texture,
                                              SourceMaterial& to) const;
  /// Sets metal and roughness, and the highlight if highlights are drawn.
  void read_shine(const GltfJson& from, bool textured, SourceMaterial& to) const;
  /// Sets colour, metal and roughness of `from`, KHR_materials_pbrSpecularGlossiness. Returns the texture of the
  /// colour: of metal that of its reflection.
  std::optional<GltfTextureUse> read_specular_glossiness(const GltfJson& from, SourceMaterial& to) const;
  /// Reads both textures if they can be shown together, else the one that can.
  GltfTexcoords read_textures(const std::optional<GltfTextureUse>& texture, std::optional<GltfTextureUse> emission,
                              SourceMaterial& to);
  /// Reads the normal and the occlusion map if they lie like the base texture.
  void read_maps(const GltfJson& from, const std::optional<GltfTextureUse>& base, SourceMaterial& to);

  const GltfJson& json_;
  GltfTextures& textures_;
  Shine shine_;
  SourceModel& model_;
  std::vector<GltfTexcoords> texcoords_;
  std::size_t without_normals_ = 0, without_occlusion_ = 0;  ///< materials whose map is not drawn
};

}  // namespace zstrip::sim
