// Meshes of a model that its joints move, posed for a frame.
#include "render/skinned_meshes.hpp"

#include <fmt/format.h>

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

SkinnedMeshes::SkinnedMeshes(const Model& model, const Animation& joints, std::string file)
    : model_(model), joints_(joints), file_(std::move(file)), meshes_(model.meshes), work_(model.joints.size()) {
  for (const ModelSkin& skin : model.skins) {
    MeshData& moved = moved_.emplace_back();
    moved.positions.resize(skin.bind.positions.size());
    moved.normals.resize(skin.bind.normals.size());
    moved.meshlets.resize(skin.bind.meshlets.size());
  }
}

Result<std::span<const Mesh>> SkinnedMeshes::at(std::uint32_t frame, std::uint32_t frames) {
  if (!moves()) return std::span<const Mesh>(model_.meshes);
  pose_ = model_.rest;
  const std::uint32_t milliseconds = time_of_frame(joints_, frame, frames);
  pose(joints_, milliseconds, pose_);
  for (std::size_t i = 0; i < moved_.size(); ++i) {
    const ModelSkin& skin = model_.skins[i];
    const MovedVertices moved{moved_[i].positions, moved_[i].normals, moved_[i].meshlets};
    const Status status = skin_mesh({&skin.bind, skin.vertices, model_.joints, model_.rest}, pose_, work_, moved);
    if (!status) {
      return Failure{ExitStatus::input, fmt::format("'{}': {} ms after its start the animation moves {}", file_,
                                                    milliseconds, too_far(skin, status))};
    }
    meshes_[skin.mesh] = moved_mesh(skin.bind, moved);
  }
  return std::span<const Mesh>(meshes_);
}

std::string SkinnedMeshes::too_far(const ModelSkin& skin, const Status& status) {
  // pose_skin, which makes only the matrices, fails only because of joints.
  const Skin of_core{&skin.bind, skin.vertices, model_.joints, model_.rest};
  Skinning skinning{.skin = &of_core, .matrices = work_, .positions = {}};
  if (!pose_skin(skinning, pose_)) return fmt::format("{} too far", name_of(model_, status.needed));
  return fmt::format("vertex {} out of the box of its mesh, most of all by {}", status.needed,
                     name_of(model_, skin.vertices[status.needed].joints[0]));
}

Result<std::span<const Mesh>> SkinnedMeshes::all_poses() {
  if (!moves()) return std::span<const Mesh>(model_.meshes);
  all_.assign(moved_.size(), {});
  for (std::uint32_t frame = 0; frame < kFramesSeen; ++frame) {
    if (const auto posed = at(frame, kFramesSeen); !posed) return posed.failure();
    for (std::size_t i = 0; i < moved_.size(); ++i) {
      all_[i].insert(all_[i].end(), moved_[i].positions.begin(), moved_[i].positions.end());
    }
  }
  for (std::size_t i = 0; i < moved_.size(); ++i) meshes_[model_.skins[i].mesh].positions = all_[i];
  return std::span<const Mesh>(meshes_);
}

}  // namespace zstrip::sim
