// Assimp's bones: the positions of a mesh's vertices at rest.
#include "import/assimp/bones.hpp"

#include <cmath>
#include <numeric>
#include <span>

namespace zstrip::sim {
namespace {

/// False for matrices that make a vertex vanish, or that have invalid numbers: such bones move nothing.
bool is_usable(const aiMatrix4x4& matrix) {
  const double size = std::abs(double{matrix.Determinant()});
  return std::isfinite(size) && size > 1e-12;
}

aiMatrix4x4 world_of(const aiNode& node) {
  aiMatrix4x4 world;
  for (const aiNode* at = &node; at != nullptr; at = at->mParent) world = at->mTransformation * world;
  return world;
}

struct Influence {
  unsigned bone;
  float weight;
};

}  // namespace

std::vector<aiMatrix4x4> bones_at_rest(const aiScene& scene, const aiMatrix4x4& turn, const aiMesh& mesh,
                                       const aiMatrix4x4& transform) {
  std::vector<aiMatrix4x4> at_rest;
  if (!mesh.HasBones()) return at_rest;
  std::vector<aiMatrix4x4> to_file;
  std::vector<std::vector<Influence>> influences(mesh.mNumVertices);
  for (const aiBone* bone : std::span(mesh.mBones, mesh.mNumBones)) {
    const aiNode* const node = scene.mRootNode->FindNode(bone->mName);
    const aiMatrix4x4 world = node == nullptr ? transform : turn * world_of(*node);
    to_file.push_back(world * bone->mOffsetMatrix);
    if (!is_usable(world) || !is_usable(bone->mOffsetMatrix)) continue;
    for (const aiVertexWeight& weight : std::span(bone->mWeights, bone->mNumWeights)) {
      if (weight.mVertexId >= influences.size() || !(weight.mWeight > 0) || !std::isfinite(weight.mWeight)) continue;
      influences[weight.mVertexId].push_back({static_cast<unsigned>(to_file.size() - 1), weight.mWeight});
    }
  }
  for (const std::vector<Influence>& each : influences) {
    // Vertices without a bone move with the mesh's node.
    if (each.empty()) {
      at_rest.push_back(transform);
      continue;
    }
    const double sum = std::accumulate(each.begin(), each.end(), 0.0, [](double all, const Influence& influence) {
      return all + double{influence.weight};
    });
    aiMatrix4x4 blended = aiMatrix4x4() * 0.0F;
    for (const auto& [bone, weight] : each) {
      blended = blended + to_file[bone] * static_cast<float>(double{weight} / sum);
    }
    at_rest.push_back(blended);
  }
  return at_rest;
}

}  // namespace zstrip::sim
