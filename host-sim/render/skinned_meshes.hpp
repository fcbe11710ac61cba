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

/// Owns the moved meshes. `model` and `joints`, an animation of the model's joints, must outlive it. `file`: the
/// model's, for messages.
class SkinnedMeshes {
 public:
  SkinnedMeshes(const Model& model, const Animation& joints, std::string file);

  /// True if frames differ.
  bool moves() const { return !joints_.tracks.empty() && !model_.skins.empty(); }
  /// Returns the meshes of the model, with skins posed for frame `frame` of `frames` frames that show the animation
  /// once. Valid until the next call.
  Result<std::span<const Mesh>> at(std::uint32_t frame, std::uint32_t frames);
  /// Returns meshes that have the positions of many frames, for results that depend on all frames. Valid until the next
  /// call.
  Result<std::span<const Mesh>> all_poses();

 private:
  /// Returns the joint or vertex that the animation moves too far, for a skin that could not be posed.
  std::string too_far(const ModelSkin& skin, const Status& status);

  const Model& model_;
  Animation joints_;
  std::string file_;
  std::vector<Mesh> meshes_;
  std::vector<MeshData> moved_;  ///< one for each skin
  std::vector<std::vector<Position>> all_;
  std::vector<JointPose> pose_;
  std::vector<Transform> work_;
};

}  // namespace zstrip::sim
