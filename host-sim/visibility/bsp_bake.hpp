// Bakes a tree that orders a scene's triangles from far to near for every eye (Fuchs, Kedem and Naylor, 1980).
#pragma once

#include <vector>

#include "result.hpp"
#include "visibility/polygon_soup.hpp"
#include "zstrip/scene/bsp_tree.hpp"

namespace zstrip::sim {

/// The scene with its triangles split by the planes of others, and the tree of these triangles.
struct BakedBsp {
  SoupScene scene;
  std::vector<BspNode> nodes;
  std::uint32_t depth = 0;  ///< nodes from the root to the farthest leaf
  std::size_t splits = 0;

  BspTree tree() const { return {nodes}; }
};

/// Returns a usage error if there are more pieces than a mesh can hold.
Result<BakedBsp> bake_bsp(const PolygonSoup& soup);

}  // namespace zstrip::sim
