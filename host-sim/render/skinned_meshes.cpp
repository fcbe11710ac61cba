// Meshes of a model that its joints and morph targets move, posed for a frame.
#include "render/skinned_meshes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "text/text.hpp"

namespace zstrip::sim {
namespace {

constexpr std::uint32_t kFramesSeen = 24;

/// Returns the name of the joint's node, or of the nearest ancestor that is a node.
std::string name_of(const Model& model, std::size_t joint) {
  std::size_t at = joint;
  while (model.joint_nodes[at].node == kNoNode && model.joint_nodes[at].parent != kNoSourceJoint) {
    at = model.joint_nodes[at].parent;
  }
  const std::int32_t node = model.joint_nodes[at].node;
  if (node == kNoNode) return fmt::format("joint {}", joint);
  return fmt::format("joint '{}'", printable(model.tree.nodes[static_cast<std::size_t>(node)].name));
}

}  // namespace

SkinnedMeshes::SkinnedMeshes(const Model& model, const Animation& joints, const WeightAnimation& weights,
                             std::string file)
    : model_(model),
      joints_(joints),
      weight_animation_(weights),
      file_(std::move(file)),
      meshes_(model.meshes),
      work_(model.joints.size()) {
  const auto lend = [this](std::size_t mesh, const Mesh& base) {
    MeshData& moved = moved_[mesh];
    moved.positions.resize(base.positions.size());
    moved.normals.resize(base.normals.size());
    moved.meshlets.resize(base.meshlets.size());
  };
  for (const ModelMorph& morph : model.morphs) lend(morph.mesh, morph.base);
  for (const ModelSkin& skin : model.skins) lend(skin.mesh, skin.bind);
}

std::size_t SkinnedMeshes::vertices() const {
  std::size_t sum = 0;
  for (const ModelSkin& skin : model_.skins) sum += moves() ? skin.bind.positions.size() : 0;
  return sum;
}

MovedVertices SkinnedMeshes::memory_of(std::size_t mesh) {
  MeshData& moved = moved_[mesh];
  return {moved.positions, moved.normals, moved.meshlets};
}

Failure SkinnedMeshes::refused(std::uint32_t milliseconds, const std::string& what) const {
  return {ExitStatus::input, fmt::format("'{}': {} ms after its start the animation {}", file_, milliseconds, what)};
}

Result<std::span<const Mesh>> SkinnedMeshes::at(std::uint32_t frame, std::uint32_t frames) {
  const std::uint32_t duration = std::max(joints_.duration, weight_animation_.duration);
  const std::uint32_t milliseconds = time_of_frame(Animation{{}, {}, duration}, frame, frames);
  if (moves_weights()) {
    if (const Result<Done> done = move_morphs(milliseconds); !done) return done.failure();
  }
  if (moves_joints() || (moves_weights() && !model_.skins.empty())) {
    if (const Result<Done> done = move_skins(milliseconds); !done) return done.failure();
  }
  return std::span<const Mesh>(meshes_);
}

Result<Done> SkinnedMeshes::move_morphs(std::uint32_t milliseconds) {
  weights_.assign(model_.weights.size(), 0);
  pose(weight_animation_, milliseconds, weights_);
  for (const ModelMorph& morph : model_.morphs) {
    const MovedVertices moved = memory_of(morph.mesh);
    if (const Status status = morph_mesh({&morph.base, morph.targets}, weights_, moved); !status) {
      std::int32_t sum = 0;
      for (const MorphTarget& target : morph.targets) sum += std::abs(std::int32_t{weights_[target.weight]});
      if (sum >= 16 * kMorphOne) {
        return refused(milliseconds, "has weights of morph targets that add up to 16 or more; leave some out");
      }
      return refused(milliseconds, fmt::format("morphs vertex {} out of the box of its mesh", status.needed));
    }
    meshes_[morph.mesh] = moved_mesh(morph.base, moved);
  }
  return Done{};
}

Result<Done> SkinnedMeshes::move_skins(std::uint32_t milliseconds) {
  pose_ = model_.rest;
  pose(joints_, milliseconds, pose_);
  for (const ModelSkin& skin : model_.skins) {
    const MovedVertices moved = memory_of(skin.mesh);
    const bool morphs = moves_weights() && model_.morph_of(skin.mesh) != nullptr;
    const Mesh from = morphs ? moved_mesh(skin.bind, moved) : skin.bind;
    const Skin of_core{&from, skin.vertices, model_.joints, model_.rest};
    if (const Status status = skin_mesh(of_core, pose_, work_, moved); !status) {
      return refused(milliseconds, "moves " + too_far(of_core, status));
    }
    meshes_[skin.mesh] = moved_mesh(skin.bind, moved);
  }
  return Done{};
}

std::string SkinnedMeshes::too_far(const Skin& skin, const Status& status) {
  // pose_skin, which makes only the matrices, fails only because of joints.
  Skinning skinning{.skin = &skin, .matrices = work_, .positions = {}};
  if (!pose_skin(skinning, pose_)) return fmt::format("{} too far", name_of(model_, status.needed));
  return fmt::format("vertex {} out of the box of its mesh, most of all by {}", status.needed,
                     name_of(model_, skin.vertices[status.needed].joints[0]));
}

Result<std::span<const Mesh>> SkinnedMeshes::all_poses() {
  if (!moves()) return std::span<const Mesh>(model_.meshes);
  all_.clear();
  for (std::uint32_t frame = 0; frame < kFramesSeen; ++frame) {
    const auto posed = at(frame, kFramesSeen);
    if (!posed) return posed.failure();
    for (const auto& [mesh, moved] : moved_) {
      const std::span<const Position> positions = (*posed)[mesh].positions;
      all_[mesh].insert(all_[mesh].end(), positions.begin(), positions.end());
    }
  }
  for (const auto& [mesh, positions] : all_) meshes_[mesh].positions = positions;
  return std::span<const Mesh>(meshes_);
}

}  // namespace zstrip::sim
