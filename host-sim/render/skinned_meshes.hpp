// Meshes of a model that its joints move, posed for a frame.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "import/model.hpp"
#include "motion/fitted_animation.hpp"
#include "result.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::sim {

/// Owns what it moves. `model` and `joints`, an animation of the model's joints, outlive it. `file`: the model's, for
/// messages.
class SkinnedMeshes {
 public:
  SkinnedMeshes(const Model& model, const Animation& joints, std::string file);

  /// Whether frames differ.
  bool moves() const { return !joints_.tracks.empty() && !model_.skins.empty(); }
  /// The meshes of the model, skins as they are at frame `frame` of `frames` that show the animation once. Valid until
  /// the next call.
  Result<std::span<const Mesh>> at(std::uint32_t frame, std::uint32_t frames);
  /// Meshes that have the positions of many frames, for what depends on all of them. Valid likewise.
  Result<std::span<const Mesh>> all_poses();

 private:
  /// What the animation moves too far, of a skin that could not be posed.
  std::string too_far(const ModelSkin& skin, const Status& status);

  const Model& model_;
  Animation joints_;
  std::string file_;
  std::vector<Mesh> meshes_;
  std::vector<MeshData> moved_;  ///< of each skin
  std::vector<std::vector<Position>> all_;
  std::vector<JointPose> pose_;
  std::vector<Transform> work_;
};

}  // namespace zstrip::sim
