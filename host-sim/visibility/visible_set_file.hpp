// A file of potentially visible sets, as `zstrip render` reads it.
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
  /// An input error if there is none such; what it holds is looked at by at().
  static Result<VisibleSetFile> read(const std::string& path);

  /// For VisibilityOptions::potentially_visible of a frame; valid as long as this. Input errors: damaged, or of another
  /// scene. Usage errors: an orthographic camera, or one whose near plane is nearer than that of the sets.
  Result<std::span<const std::uint32_t>> at(const Scene& scene, const Camera& camera, const Animation& animation) const;

 private:
  std::string path_;
  std::vector<std::uint32_t> words_;  ///< aligned; the last one is filled up
  std::size_t bytes_ = 0;
};

}  // namespace zstrip::sim
