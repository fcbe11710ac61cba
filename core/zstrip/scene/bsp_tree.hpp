// A tree that gives triangles of one mesh their order from far to near for every eye (Fuchs, Kedem and Naylor, "On
// Visible Surface Generation by a Priori Tree Structures", 1980). Baked on the host, read in place.
#pragma once

#include <cstdint>
#include <span>

namespace zstrip {

/// A plane and the triangles in it: from first_triangle to that of the next node, or to the mesh's last one. Children
/// are indices of nodes that come later, 0 for none.
struct BspNode {
  std::int32_t x, y, z;          ///< of the normal, 2.30 of the mesh's bounding box: positions are 1.15
  std::int32_t distance;         ///< 2.30: in front are positions with normal * position > distance
  std::uint32_t first_triangle;  ///< of the mesh
  std::uint32_t front, back;
  std::uint32_t parent;  ///< 0 of the root, which is the first node
};

/// Of a scene of one instance of one mesh, whose triangles lie in the order of the nodes. Of any depth: it is walked
/// along its links, without a stack.
struct BspTree {
  std::span<const BspNode> nodes;
};

}  // namespace zstrip
