// Assimp's bones: where they hold a mesh' vertices at rest.
#pragma once

#include <assimp/scene.h>

#include <vector>

namespace zstrip::sim {

/// Of a mesh with bones on this node, whose `transform` leads to the file's coordinates: one matrix a vertex, to these.
/// `turn` comes after all nodes. Empty: it has no bones, and stays where its node is.
std::vector<aiMatrix4x4> bones_at_rest(const aiScene& scene, const aiMatrix4x4& turn, const aiMesh& mesh,
                                       const aiMatrix4x4& transform);

}  // namespace zstrip::sim
