// Assimp's bones: the positions of a mesh's vertices at rest.
#pragma once

#include <assimp/scene.h>

#include <vector>

namespace zstrip::sim {

/// For a mesh with bones on this node, whose `transform` maps to the file's coordinates: returns one matrix for each
/// vertex, to these coordinates. `turn` is applied after all nodes. Empty: the mesh has no bones, and moves with its
/// node.
std::vector<aiMatrix4x4> bones_at_rest(const aiScene& scene, const aiMatrix4x4& turn, const aiMesh& mesh,
                                       const aiMatrix4x4& transform);

}  // namespace zstrip::sim
