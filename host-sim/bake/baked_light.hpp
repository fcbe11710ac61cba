// Light of a scene to be baked, as colours of vertices.
#pragma once

#include <cstddef>
#include <deque>
#include <set>
#include <vector>

#include "zstrip/scene.hpp"

namespace zstrip::sim {

/// A scene whose directional and ambient light is in the colours of its vertices, which then have no normals. At rest
/// it has the same pixels. An instance stays lit if colours of vertices cannot hold its light: with a texture, light at
/// pixels, a highlight, emission, an outline, an alpha below 255 that is used, as a billboard, or if another instance
/// shows the mesh in other light. Nothing changes in scenes with point or spot lights, shadows or CSG. Refers to the
/// arrays of the original scene.
class LightBakedScene {
 public:
  /// `kept`: meshes whose instances stay lit, because they move.
  LightBakedScene(const Scene& scene, std::set<std::size_t> kept);
  LightBakedScene(const LightBakedScene&) = delete;
  LightBakedScene& operator=(const LightBakedScene&) = delete;

  const Scene& scene() const { return scene_; }
  /// Returns the number of instances whose light was baked.
  std::size_t baked() const { return baked_; }

 private:
  Scene scene_;
  std::vector<Mesh> meshes_;
  std::vector<Material> materials_;
  std::vector<Instance> instances_;
  std::deque<std::vector<Colour>> colours_;
  std::size_t baked_ = 0;
};

}  // namespace zstrip::sim
