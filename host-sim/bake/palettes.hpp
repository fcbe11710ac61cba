// Palettes for the textures of a scene that is to be baked.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "image/palette.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::sim {

/// What becomes of textures of RGB565, where it takes fewer bytes.
enum class TextureChoice {
  rgb565,     ///< they stay
  automatic,  ///< a palette if it loses nothing
  palette8,   ///< one of 16 colours if it loses nothing, else one of 256
  palette4,   ///< one of 16 colours
};

/// A texture that has got a palette.
struct PaletteRecord {
  std::size_t texture = 0;  ///< its index
  TextureFormat format{};
  std::uint64_t bytes = 0, bytes_before = 0;
  TexelErrors errors;
};

/// A scene whose textures have the palettes of a choice. Textures with alpha, those of quadrics and those without
/// instances stay. Materials whose texture has got a palette get a finish if they have none; where the table of
/// finishes is full, nothing changes. Refers to the arrays of the scene that it was made of.
class PalettedScene {
 public:
  PalettedScene(const Scene& scene, TextureChoice choice);
  PalettedScene(const PalettedScene&) = delete;
  PalettedScene& operator=(const PalettedScene&) = delete;

  const Scene& scene() const { return scene_; }
  const std::vector<PaletteRecord>& records() const { return records_; }
  /// By the textures.
  std::uint64_t saved_bytes() const;

 private:
  Scene scene_;
  std::vector<Texture> textures_;
  std::vector<Material> materials_;
  std::vector<Finish> finishes_;
  std::deque<std::vector<std::uint16_t>> words_;
  std::vector<PaletteRecord> records_;
};

}  // namespace zstrip::sim
