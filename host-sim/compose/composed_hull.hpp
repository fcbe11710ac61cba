// The hull of a mesh with an outline: see Outline in zstrip/scene.hpp.
#pragma once

#include <vector>

#include "import/model.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::sim {

/// True if the mesh can be its own hull: it has normals, and vertices in one place have equal normals.
bool is_own_hull(const Mesh& mesh);

/// Returns a hull of the mesh's triangles: one vertex in each place, whose normal keeps the width of the outline along
/// the edges of all faces around it, within the range of a normal's components. In the mesh's coordinates; several
/// meshes if there are more vertices than one can have.
std::vector<MeshData> hull_of(const Mesh& mesh);

}  // namespace zstrip::sim
