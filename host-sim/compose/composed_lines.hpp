// Lines and points of a composed scene: connections of a model's vertices, and meshes of separate vertices.
#pragma once

#include <span>
#include <vector>

#include "import/model.hpp"
#include "motion/affine.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::sim {

/// Returns each edge of the mesh's triangles once, also if its vertices occur more than once, as at seams of textures.
std::vector<Segment> edges_of(const Mesh& mesh);
/// Returns each place of a vertex once, as a point.
std::vector<Segment> points_of(const Mesh& mesh);

/// Returns a mesh of these vertices, in units of the scene, at most 65,535. `own` gets the data that the mesh refers
/// to.
Mesh mesh_of(std::span<const Vector> vertices, MeshData& own);

}  // namespace zstrip::sim
