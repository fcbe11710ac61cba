// A file of potentially visible sets, for `zstrip render`.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "result.hpp"
#include "zstrip/animation.hpp"
#include "zstrip/camera.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/visibility.hpp"

namespace zstrip::sim {

class VisibleSetFile {
 public:
  /// Returns an input error if the file does not exist; at() checks its contents.
  static Result<VisibleSetFile> read(const std::string& path);

  /// Returns the words for VisibilityOptions::potentially_visible of a frame; valid as long as this object. Input
  /// errors: damaged, or of another scene. Usage errors: an orthographic camera, or a camera with a nearer near plane
  /// than the sets'.
  Result<std::span<const std::uint32_t>> at(const Scene& scene, const Camera& camera, const Animation& animation) const;

 private:
  std::string path_;
  std::vector<std::uint32_t> words_;  ///< aligned; the last word is padded
  std::size_t bytes_ = 0;
};

}  // namespace zstrip::sim
