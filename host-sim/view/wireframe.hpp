// A scene of which only the edges of its triangles are drawn.
#pragma once

#include <vector>

#include "render/stage.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::sim {

class Wireframe {
 public:
  /// The edges of all instances, white on black; labels and sprites stay. Views this object and what `staging` views;
  /// until the next call.
  Staging of(const Staging& staging);

 private:
  std::vector<std::vector<Segment>> edges_;  ///< by mesh; empty: nothing has it
  std::vector<LineSet> lines_;
};

}  // namespace zstrip::sim
