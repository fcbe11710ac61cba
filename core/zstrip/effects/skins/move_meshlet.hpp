// Moves a meshlet of a skin into the RAM of its Skinning.
#pragma once

#include "zstrip/geometry/meshlet_range.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::detail::skins {

/// Returns the mesh with the vertices from `first_vertex` on in the memory into which move_positions and move_normals
/// write; returns `mesh` itself if it has no skin, or the skin has no pose. Valid until the next call for this skin.
const Mesh& begin_meshlet(const Mesh& mesh, std::uint32_t first_vertex);

// Both take a mesh that begin_meshlet returned, and do nothing if it is not a skin's.
/// `range`: the meshlet's.
void move_positions(const Mesh& mesh, const MeshletRange& range);
/// `range`: any vertices of the meshlet.
void move_normals(const Mesh& mesh, const MeshletRange& range);

}  // namespace zstrip::detail::skins
