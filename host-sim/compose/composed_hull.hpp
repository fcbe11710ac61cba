// The hull of a mesh with an outline: see Outline in zstrip/scene.hpp.
#pragma once

#include <vector>

#include "import/model.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::sim {

/// Whether the mesh can be its own hull: it has normals, and vertices in one place have the same.
bool is_own_hull(const Mesh& mesh);

/// A hull of the mesh's triangles: one vertex in each place, whose normal keeps the width of the outline along the
/// edges of all faces around it, as far as a normal's components reach. In the mesh's coordinates; several where there
/// are more vertices than a mesh can have.
std::vector<MeshData> hull_of(const Mesh& mesh);

}  // namespace zstrip::sim
