// Lines and points of a composed scene: what joins the vertices of a model, and meshes of vertices of their own.
#pragma once

#include <span>
#include <vector>

#include "import/model.hpp"
#include "motion/affine.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::sim {

/// Each edge of the mesh's triangles once, also where its vertices are there more than once, as at seams of textures.
std::vector<Segment> edges_of(const Mesh& mesh);
/// Each place of a vertex once, as a point.
std::vector<Segment> points_of(const Mesh& mesh);

/// A mesh of these vertices, in units of the scene, at most 65,535. `own` gets what it views.
Mesh mesh_of(std::span<const Vector> vertices, MeshData& own);

}  // namespace zstrip::sim
