// Palettes for the textures of a scene to be baked.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "image/palette.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::sim {

/// The conversion of RGB565 textures, applied if it takes fewer bytes.
enum class TextureChoice {
  rgb565,     ///< no conversion
  automatic,  ///< a palette if it is lossless
  palette8,   ///< 16 colours if that is lossless, else 256
  palette4,   ///< 16 colours
};

/// A texture that was converted to a palette.
struct PaletteRecord {
  std::size_t texture = 0;  ///< its index
  TextureFormat format{};
  std::uint64_t bytes = 0, bytes_before = 0;
  TexelErrors errors;
};

/// A scene whose textures have the palettes of a choice. Textures with alpha, textures of quadrics and textures without
/// instances do not change. Materials whose texture gets a palette get a finish if they have none; if the table of
/// finishes is full, they do not change. Refers to the arrays of the original scene.
class PalettedScene {
 public:
  PalettedScene(const Scene& scene, TextureChoice choice);
  PalettedScene(const PalettedScene&) = delete;
  PalettedScene& operator=(const PalettedScene&) = delete;

  const Scene& scene() const { return scene_; }
  const std::vector<PaletteRecord>& records() const { return records_; }
  /// Returns the bytes that the palettes save.
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
