// A tree that gives the triangles of one mesh in the order from far to near, for any eye (Fuchs, Kedem and Naylor, "On
// Visible Surface Generation by a Priori Tree Structures", 1980). Baked on the host, read in place.
#pragma once

#include <cstdint>
#include <span>

namespace zstrip {

/// A plane and the triangles in it: from first_triangle to that of the next node, or to the mesh's last triangle.
/// Children are indices of later nodes; 0 means no child.
struct BspNode {
  std::int32_t x, y, z;          ///< the plane's normal, 2.30 of the mesh's bounding box: positions are 1.15
  std::int32_t distance;         ///< 2.30; positions with normal * position > distance are in front
  std::uint32_t first_triangle;  ///< first triangle, an index into the mesh's triangles
  std::uint32_t front, back;
  std::uint32_t parent;  ///< 0 for the root, which is the first node
};

/// The tree of a scene with one instance of one mesh, whose triangles are in the order of the nodes. Any depth is
/// allowed: the tree is walked along its links, without a stack.
struct BspTree {
  std::span<const BspNode> nodes;
};

}  // namespace zstrip
