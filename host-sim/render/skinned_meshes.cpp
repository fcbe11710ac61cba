// Meshes of a model that its joints move, posed for a frame.
#include "render/skinned_meshes.hpp"

#include <fmt/format.h>

namespace zstrip::sim {
namespace {

constexpr std::uint32_t kFramesSeen = 24;

}  // namespace

SkinnedMeshes::SkinnedMeshes(const Model& model, const Animation& joints)
    : model_(model), joints_(joints), meshes_(model.meshes), work_(model.joints.size()) {
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
  pose(joints_, time_of_frame(joints_, frame, frames), pose_);
  for (std::size_t i = 0; i < moved_.size(); ++i) {
    const ModelSkin& skin = model_.skins[i];
    const MovedVertices moved{moved_[i].positions, moved_[i].normals, moved_[i].meshlets};
    const Status status = skin_mesh({&skin.bind, skin.vertices, model_.joints, model_.rest}, pose_, work_, moved);
    if (!status) {
      return Failure{ExitStatus::input, fmt::format("frame {}: {} (number {}); the animation moves it too far", frame,
                                                    message(status.error), status.needed)};
    }
    meshes_[skin.mesh] = moved_mesh(skin.bind, moved);
  }
  return std::span<const Mesh>(meshes_);
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
