// The edges that a scene's own motion shows, for headers: 8 bytes of flash each.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "zstrip/scene.hpp"
#include "zstrip/view.hpp"
#include "zstrip_scenes/baked_stage.hpp"

namespace zstrip::sim {

/// A scene without the edges that no frame of its motion shows: in each, both faces are turned away, or both are seen
/// and the edge is not a crease. An edge stays if a rounded corner may decide; edges of billboards all stay. The other
/// arrays are those of the scene.
class ShownEdges {
 public:
  /// Looks at all frames of the motion up to 4,096. `bent`: meshes of which all edges stay, because joints move them.
  ShownEdges(const scenes::AtRest& at_rest, const View& view, std::span<const std::size_t> bent);
  ShownEdges(const ShownEdges&) = delete;
  ShownEdges& operator=(const ShownEdges&) = delete;

  std::span<const EdgeSet> sets() const { return sets_; }
  std::size_t left_out() const { return left_out_; }

 private:
  std::vector<std::vector<Edge>> lists_;
  std::vector<EdgeSet> sets_;
  std::size_t left_out_ = 0;
};

}  // namespace zstrip::sim
