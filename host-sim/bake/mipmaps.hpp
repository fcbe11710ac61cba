// Mipmaps for the textures of a scene to be baked.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "zstrip/scene.hpp"

namespace zstrip::sim {

/// Selects the textures with smaller levels.
enum class MipmapChoice {
  automatic,  ///< the textures that the scene selects
  on,         ///< all textures of instances that are larger than one texel
  off,        ///< none
};

/// A texture with smaller levels in a material with a finish.
struct MipmapRecord {
  std::size_t texture = 0;  ///< its index
  unsigned levels = 0;      ///< number of smaller levels
  std::uint64_t bytes = 0;  ///< of these levels
};

/// A scene whose textures have the levels of a choice. With `on`, materials of instances without a finish get one; if
/// the table of finishes is full, they do not change. Refers to the arrays of the original scene.
class MipmappedScene {
 public:
  MipmappedScene(const Scene& scene, MipmapChoice choice);
  MipmappedScene(const MipmappedScene&) = delete;
  MipmappedScene& operator=(const MipmappedScene&) = delete;

  const Scene& scene() const { return scene_; }

 private:
  void add_levels();

  Scene scene_;
  std::vector<Texture> textures_;
  std::vector<Material> materials_;
  std::vector<Finish> finishes_;
  std::deque<std::vector<std::uint16_t>> words_;
};

/// Returns the records of all textures that are drawn with mipmaps.
std::vector<MipmapRecord> mipmap_records(const Scene& scene);

}  // namespace zstrip::sim
