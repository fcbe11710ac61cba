// The edges of a mesh, for the renderer's anti-aliasing of edges: see Edge in zstrip/scene.hpp.
#pragma once

#include <vector>

#include "zstrip/scene.hpp"

namespace zstrip::sim {

/// One for each two places that a triangle's side joins, whatever vertices lie there, with both faces; sides that more
/// than two faces or two in the same direction share are edges of one face each. Creases where normals or colours of
/// the two faces differ at an end, or, if `flat`, where they are not in one plane. In the order of the meshlets.
/// Triangles without an area in the mesh's grid have none.
std::vector<Edge> find_edges(const Mesh& mesh, bool flat);

/// For Scene::edges; what `sets` view is in `lists`.
struct SceneEdges {
  std::vector<std::vector<Edge>> lists;
  std::vector<EdgeSet> sets;
};

/// Those of all meshes that instances have. A mesh is flat if any of its instances is.
SceneEdges find_edges(const Scene& scene);

}  // namespace zstrip::sim
