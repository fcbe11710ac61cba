// A meshlet of a skin, moved into the RAM of its Skinning.
#pragma once

#include "zstrip/geometry/meshlet_range.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::detail::skins {

/// The mesh with the vertices from `first_vertex` on where move_positions and move_normals write them; `mesh` itself
/// where it has no skin that has been posed. Until the next call for this skin.
const Mesh& begin_meshlet(const Mesh& mesh, std::uint32_t first_vertex);

// Both are for a mesh that begin_meshlet has returned. If it is not a skin's they do nothing.
/// `range`: the meshlet's.
void move_positions(const Mesh& mesh, const MeshletRange& range);
/// `range`: of any vertices of the meshlet.
void move_normals(const Mesh& mesh, const MeshletRange& range);

}  // namespace zstrip::detail::skins
