// Removes from a scene the tables that move vertices while they are drawn. They are in RAM, so neither headers nor
// blobs keep them.
#pragma once

#include <vector>

#include "zstrip/scene.hpp"

namespace zstrip::sim {

/// Its meshes have the shape that was modelled. The other arrays are those of the scene.
class UnmovedScene {
 public:
  explicit UnmovedScene(const Scene& scene) : meshes_(scene.meshes.begin(), scene.meshes.end()), scene_(scene) {
    for (Mesh& mesh : meshes_) {
      moved_ = moved_ || mesh.skinning != nullptr;
      mesh.skinning = nullptr;
    }
    scene_.meshes = meshes_;
  }
  UnmovedScene(const UnmovedScene&) = delete;
  UnmovedScene& operator=(const UnmovedScene&) = delete;

  const Scene& scene() const { return scene_; }
  /// True if something was left out.
  bool moved() const { return moved_; }

 private:
  std::vector<Mesh> meshes_;
  Scene scene_;
  bool moved_ = false;
};

}  // namespace zstrip::sim
