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
  /// Adds to `scene`.
  ComposedMaterials(const SceneFile& file, ComposedScene& scene) : file_(file), scene_(scene) {}

  /// The index of the part's material, with what the scene file replaces in it.
  Result<std::uint16_t> index_of(const PlacedPart& placed);
  /// Of an ellipsoid, which has no model's material to begin with.
  Result<std::uint16_t> index_of(const FileMaterial& material);
  /// What replaces the part's material; null if nothing does.
  const FileMaterial* override_of(const PlacedPart& placed) const;
  /// Whether something in the file gives a texture to parts of the model of this name.
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
