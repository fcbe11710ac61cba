// Assimp's bones as joints: which of them move a vertex, and from where.
#include "import/bones.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "report/number.hpp"
#include "zstrip/skin.hpp"

namespace zstrip::sim {
namespace {

bool nearly_equal(const Affine& a, const Affine& b) {
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 4; ++column) {
      const double scale = std::max({1.0, std::abs(a.m[row][column]), std::abs(b.m[row][column])});
      if (std::abs(a.m[row][column] - b.m[row][column]) > 1e-5 * scale) return false;
    }
  }
  return true;
}

bool is_usable(const aiMatrix4x4& matrix) {
  const Affine affine = to_affine(matrix);
  double sum = 0;
  for (const auto& row : affine.m) sum += std::abs(row[0]) + std::abs(row[1]) + std::abs(row[2]) + std::abs(row[3]);
  return std::isfinite(sum) && std::abs(determinant(affine)) > 1e-12;
}

}  // namespace

BoneReader::BoneReader(const aiScene& scene, const aiMatrix4x4& turn, const MovedNodes& moved, SourceModel& model)
    : scene_(scene), turn_(turn), moved_(moved), model_(model) {}

const aiNode* BoneReader::node_of(const aiBone& bone) const { return scene_.mRootNode->FindNode(bone.mName); }

aiMatrix4x4 BoneReader::world_of(const aiNode& node) const {
  aiMatrix4x4 world;
  for (const aiNode* at = &node; at != nullptr; at = at->mParent) world = at->mTransformation * world;
  return turn_ * world;
}

std::size_t BoneReader::joint_of_node(std::int32_t node) {
  if (node == kNoNode) return kNoSourceJoint;
  std::vector<SourceJoint>& joints = model_.joints;
  const auto known = std::ranges::find(joints, node, &SourceJoint::node);
  if (known != joints.end()) return static_cast<std::size_t>(known - joints.begin());
  const std::size_t parent = joint_of_node(model_.nodes.nodes[static_cast<std::size_t>(node)].parent);
  joints.push_back({.parent = parent, .node = node, .inverse_bind = {}});
  return joints.size() - 1;
}

/// `node`: the bone's, which may not be there; `world`: to the file's coordinates.
std::size_t BoneReader::joint_with(const aiNode* node, const aiMatrix4x4& world, const aiMatrix4x4& offset,
                                   const aiMatrix4x4& modelled) {
  std::vector<SourceJoint>& joints = model_.joints;
  const std::int32_t mover = node == nullptr ? kNoNode : moved_.mover_of(*node);
  Affine bind = to_affine(world) * to_affine(offset) * inverse(to_affine(modelled));
  if (mover != kNoNode) bind = inverse(model_.nodes.at_rest(mover)) * bind;
  const std::size_t of_mover = joint_of_node(mover);
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const bool hangs_there = i == of_mover || (joints[i].node == kNoNode && joints[i].parent == of_mover);
    if (hangs_there && joints[i].has_vertices && nearly_equal(joints[i].inverse_bind, bind)) return i;
  }
  std::size_t index = of_mover;
  if (of_mover == kNoSourceJoint || joints[of_mover].has_vertices) {
    index = joints.size();
    joints.push_back({.parent = of_mover, .node = kNoNode, .inverse_bind = {}});
  }
  joints[index].inverse_bind = bind;
  joints[index].has_vertices = true;
  return index;
}

VertexBones BoneReader::strongest(const std::vector<Influence>& influences, const std::vector<std::size_t>& joints) {
  std::map<std::size_t, double> by_joint;
  for (const Influence& influence : influences) by_joint[joints[influence.bone]] += influence.weight;
  std::vector<std::pair<double, std::size_t>> sorted;
  for (const auto& [joint, weight] : by_joint) sorted.emplace_back(weight, joint);
  std::ranges::stable_sort(sorted, std::greater<>(), &std::pair<double, std::size_t>::first);
  if (sorted.size() > 4) {
    ++weakened_;
    sorted.resize(4);
  }
  double sum = 0;
  for (const auto& [weight, joint] : sorted) sum += weight;
  // 256 in all; what rounding leaves over is the first one's, which counts one more than its value.
  VertexBones vertex;
  int left = 256;
  for (std::size_t k = 1; k < sorted.size(); ++k) {
    const auto weight = static_cast<int>(std::lround(256 * sorted[k].first / sum));
    vertex.weights[k] = static_cast<std::uint8_t>(weight);
    if (weight > 0) vertex.joints[k] = static_cast<std::uint8_t>(sorted[k].second);
    left -= weight;
  }
  vertex.joints[0] = static_cast<std::uint8_t>(sorted[0].second);
  vertex.weights[0] = static_cast<std::uint8_t>(left - 1);
  return vertex;
}

MeshBones BoneReader::read(const aiMesh& mesh, const aiMatrix4x4& transform, const aiNode& on) {
  MeshBones read{.modelled = transform};
  if (!mesh.HasBones()) return read;
  const std::span<const aiBone* const> bones(mesh.mBones, mesh.mNumBones);
  // Beside the bones: what no bone moves hangs on the mesh's node.
  std::vector<aiMatrix4x4> worlds(bones.size() + 1, transform);
  std::vector<std::vector<Influence>> influences(mesh.mNumVertices);
  for (unsigned b = 0; b < bones.size(); ++b) {
    const aiNode* const node = node_of(*bones[b]);
    if (node != nullptr) worlds[b] = world_of(*node);
    if (!is_usable(worlds[b]) || !is_usable(bones[b]->mOffsetMatrix)) continue;
    for (const aiVertexWeight& weight : std::span(bones[b]->mWeights, bones[b]->mNumWeights)) {
      if (weight.mVertexId >= influences.size() || !(weight.mWeight > 0) || !std::isfinite(weight.mWeight)) continue;
      influences[weight.mVertexId].push_back({b, weight.mWeight});
    }
  }
  const auto own = static_cast<unsigned>(bones.size());
  for (std::vector<Influence>& each : influences) {
    if (each.empty()) each.push_back({own, 1});
  }
  const auto offset_of = [&](unsigned b) { return b < own ? bones[b]->mOffsetMatrix : aiMatrix4x4(); };

  const bool moves = std::ranges::any_of(bones, [&](const aiBone* bone) {
    return node_of(*bone) != nullptr && moved_.mover_of(*node_of(*bone)) != kNoNode;
  });
  if (moves) {
    const aiMatrix4x4 first = worlds[influences[0][0].bone] * offset_of(influences[0][0].bone);
    if (is_usable(first)) read.modelled = first;
    const std::size_t before = model_.joints.size();
    std::vector<std::size_t> joints(worlds.size(), kNoSourceJoint);
    for (const std::vector<Influence>& each : influences) {
      for (const auto& [b, weight] : each) {
        if (joints[b] != kNoSourceJoint) continue;
        joints[b] = joint_with(b < own ? node_of(*bones[b]) : &on, worlds[b], offset_of(b), read.modelled);
      }
    }
    if (model_.joints.size() <= kMaxJoints) {
      for (const std::vector<Influence>& each : influences) read.joints.push_back(strongest(each, joints));
      return read;
    }
    model_.joints.resize(before);
    ++still_;
  }
  for (const std::vector<Influence>& each : influences) {
    const double sum = std::accumulate(each.begin(), each.end(), 0.0,
                                       [](double all, const Influence& influence) { return all + influence.weight; });
    aiMatrix4x4 blended = aiMatrix4x4() * 0.0F;
    for (const auto& [b, weight] : each) {
      blended = blended + worlds[b] * offset_of(b) * static_cast<float>(weight / sum);
    }
    read.at_rest.push_back(blended);
  }
  return read;
}

void BoneReader::warn() const {
  if (weakened_ > 0) {
    model_.warnings.push_back(
        fmt::format("{} moved by the strongest four of their joints", counted(weakened_, "corner")));
  }
  if (still_ > 0) {
    model_.warnings.push_back(
        fmt::format("{} with a skin drawn at rest: more than {} joints", counted(still_, "mesh"), kMaxJoints));
  }
}

}  // namespace zstrip::sim
