// The edges of a mesh, for the renderer's anti-aliasing of edges: see Edge in zstrip/scene.hpp.
#pragma once

#include <span>
#include <vector>

#include "zstrip/levels.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::sim {

/// Finds one edge for each two places that a triangle's side joins, for any vertices at these places, with both faces.
/// A side with more than two faces, or with two faces in the same direction, becomes edges with one face each. An edge
/// is a crease if normals or colours of the two faces differ at an end, or, if `flat`, if the faces are not in one
/// plane. The edges are in the order of the meshlets. Triangles without an area in the mesh's grid have no edges.
std::vector<Edge> find_edges(const Mesh& mesh, bool flat);

/// For Scene::edges; `sets` refers to `lists`.
struct SceneEdges {
  std::vector<std::vector<Edge>> lists;
  std::vector<EdgeSet> sets;
};

/// Finds the edges of all meshes that instances have, and of those that `levels` give them. A mesh is flat if any of
/// its instances is.
SceneEdges find_edges(const Scene& scene, std::span<const DetailLevel> levels = {});

}  // namespace zstrip::sim
