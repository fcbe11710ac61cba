// A baked scene (.zsc) read from a file, turning about the y axis.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "zstrip/scene/scene_blob.hpp"
#include "zstrip_hal_linux/outcome.hpp"

namespace zstrip::panel {

class SceneFile {
 public:
  /// Reads and checks all of the file. Faults say what to do: bake it again, mostly.
  static hal::Outcome<SceneFile> open(const std::string& path);

  SceneFile(SceneFile&&) = default;

  const Scene& scene() const { return blob_.scene; }
  /// The blob's camera; in a picture narrower than the blob's own it shows as much from side to side.
  Camera camera(const View& view) const;
  /// Whether the picture was baked to be dithered, and with how many samples a pixel.
  bool dithers() const { return blob_.view.dither; }
  std::uint8_t samples() const { return blob_.view.samples; }
  /// Whether the scene can turn: none of its instances is too far away.
  bool can_turn() const;
  /// Frame `frame` of a full turn in `frames` frames. Valid until the next call, and as long as this object lives.
  Scene turned(std::uint32_t frame, std::uint32_t frames);

 private:
  SceneFile() = default;

  std::vector<std::uint64_t> bytes_;   ///< 8-byte words: kSceneBlobAlignment
  std::vector<std::uint64_t> tables_;  ///< lent to open_scene_blob
  SceneBlob blob_;
  std::vector<Instance> instances_;
  std::vector<LineSet> lines_;
};

}  // namespace zstrip::panel
