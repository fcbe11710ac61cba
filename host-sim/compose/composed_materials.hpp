// The materials of a composed scene, with their textures and finishes: each once for each override.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "compose/composed_scene.hpp"
#include "compose/placed_part.hpp"

namespace zstrip::sim {

class ComposedMaterials {
 public:
  /// Materials are added to `scene`.
  ComposedMaterials(const SceneFile& file, ComposedScene& scene) : file_(file), scene_(scene) {}

  /// Returns the index of the part's material, with the values that the scene file replaces.
  Result<std::uint16_t> index_of(const PlacedPart& placed);
  /// Returns the index of the material of an ellipsoid, which has no material of a model.
  Result<std::uint16_t> index_of(const FileMaterial& material);
  /// Returns the values that replace the part's material; null if there are none.
  const FileMaterial* override_of(const PlacedPart& placed) const;
  /// True if the file gives a texture to parts of the model with this name.
  bool may_texture(const std::string& model) const;

 private:
  Result<std::uint16_t> own_texture(const FileMaterial& material);
  std::uint16_t model_texture(const PlacedPart& placed, std::uint16_t texture, std::optional<bool> mipmaps);
  void add_levels(Texture& texture);
  bool set_finish(Material& material, const Finish& own, const FileMaterial& by);
  Failure too_many_finishes(int line) const;

  const SceneFile& file_;
  ComposedScene& scene_;
  std::map<std::tuple<std::size_t, std::uint16_t, std::optional<bool>>, std::uint16_t> model_textures_;
  std::map<std::tuple<std::filesystem::path, std::optional<TextureFormat>, bool>, std::uint16_t> own_textures_;
  std::map<std::tuple<std::size_t, std::uint16_t, const FileMaterial*>, std::uint16_t> materials_;
};

}  // namespace zstrip::sim
