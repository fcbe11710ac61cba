// Reads a baked scene (.zsc) from a file, with its animation or rotation.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "zstrip/blob.hpp"
#include "zstrip_hal_linux/outcome.hpp"
#include "zstrip_hal_linux/screen_size.hpp"
#include "zstrip_scenes/baked_stage.hpp"

namespace zstrip::panel {

class SceneFile {
 public:
  /// Reads and checks the whole file. Faults name the remedy, mostly to bake it again.
  static hal::Outcome<SceneFile> open(const std::string& path);

  SceneFile(SceneFile&&) = default;

  const Scene& scene() const { return blob_.scene; }
  /// Returns the size of the picture that the scene was baked for.
  hal::ScreenSize size() const { return {blob_.view.width, blob_.view.height}; }
  /// True if the picture was baked to be dithered. samples(): the number of samples a pixel that it was baked with.
  bool dithers() const { return blob_.view.dither; }
  std::uint8_t samples() const { return blob_.view.samples; }
  /// Returns the additional effects of the baked picture: one of kPictureEffects.
  Effects effects() const { return blob_.effects; }
  /// Returns the blob's camera for `frames` frames. In a narrower picture than the blob's it shows the same width.
  Camera camera(const View& view, std::uint32_t frames) const;
  /// True if the scene can rotate by 360 degrees: all rotated parts are near enough to the origin.
  bool can_turn(const Camera& camera) const;
  /// Returns frame `frame` of `frames` that show the animation once, or else a full rotation; `camera` is the result of
  /// camera(). Valid until the next call, and as long as this object lives.
  scenes::BakedFrame staged(const Camera& camera, std::uint32_t frame, std::uint32_t frames);

 private:
  SceneFile() = default;

  std::vector<std::uint64_t> bytes_;   ///< 8-byte words: kSceneBlobAlignment
  std::vector<std::uint64_t> tables_;  ///< lent to open_scene_blob
  SceneBlob blob_;
  std::vector<Instance> instances_;
  std::vector<LineSet> lines_;
};

}  // namespace zstrip::panel
