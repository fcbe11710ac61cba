// A scene as settings change it: shading, filter with its mipmaps, mesh detail, edges, depth range.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "accuracy/knobs.hpp"
#include "bake/mipmaps.hpp"
#include "import/edges.hpp"
#include "import/model.hpp"
#include "render/stage.hpp"

namespace zstrip::sim {

/// True if a mesh of the scene has enough triangles to be simplified.
bool may_simplify(const Scene& scene);

/// Meshes, materials and edges for settings with another shading, filter, detail or anti-aliasing; made once for all
/// poses of the scene. Holds views of the original scene, which must outlive it.
class SceneVariant {
 public:
  SceneVariant(const Scene& scene, const Settings& settings);
  SceneVariant(const SceneVariant&) = delete;
  SceneVariant& operator=(const SceneVariant&) = delete;

  /// Returns the staged scene with these changes, and the camera with the depth range of the settings.
  Staging apply(const Staging& staged) const;
  bool simplified() const { return !data_.empty(); }

 private:
  /// Filters all textures, except those of quadrics, which cannot have a finish.
  void filter_bilinearly();
  void simplify(std::uint32_t percent);

  bool fixed_range_;
  MipmappedScene textured_;
  std::deque<MeshData> data_;  ///< of simplified meshes
  std::vector<Mesh> meshes_;
  std::vector<Material> materials_;
  std::vector<Finish> finishes_;
  SceneEdges edges_;
};

}  // namespace zstrip::sim
