// Mipmaps for the textures of a scene that is to be baked.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "zstrip/scene.hpp"

namespace zstrip::sim {

/// Which textures have smaller levels.
enum class MipmapChoice {
  automatic,  ///< those that the scene selects
  on,         ///< all that an instance has and that are larger than one texel
  off,        ///< none
};

/// A texture with smaller levels that a material with a finish has.
struct MipmapRecord {
  std::size_t texture = 0;  ///< its index
  unsigned levels = 0;      ///< the smaller ones
  std::uint64_t bytes = 0;  ///< of these
};

/// A scene whose textures have the levels of a choice. With `on`, materials of instances get a finish if they have
/// none; where the table of finishes is full, nothing changes. Refers to the arrays of the scene that it was made of.
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

/// Of all textures that are drawn with mipmaps.
std::vector<MipmapRecord> mipmap_records(const Scene& scene);

}  // namespace zstrip::sim
