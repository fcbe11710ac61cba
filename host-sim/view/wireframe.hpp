// A scene whose instances are drawn as the edges of their triangles.
#pragma once

#include <vector>

#include "render/stage.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::sim {

class Wireframe {
 public:
  /// Edges are white, or have the colours of their vertices. Spheres, lines, labels and sprites do not change. The
  /// result refers to this object and to the data of `staging`; valid until the next call.
  Staging of(const Staging& staging);

 private:
  std::vector<Material> materials_;
  std::vector<std::vector<Segment>> edges_;  ///< by mesh; empty for meshes without instances
  std::vector<LineSet> lines_;
};

}  // namespace zstrip::sim
