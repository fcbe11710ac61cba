// Meshes of a model that its joints and morph targets move, posed for a frame.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "import/model.hpp"
#include "result.hpp"
#include "zstrip/morph.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::sim {

/// Owns the moved meshes. `model` and the animations, of the model's joints and of its weights, must outlive it.
/// `file`: the model's, for messages.
class SkinnedMeshes {
 public:
  SkinnedMeshes(const Model& model, const Animation& joints, const WeightAnimation& weights, std::string file);

  /// True if frames differ.
  bool moves() const { return moves_joints() || moves_weights(); }
  /// Returns the number of vertices of skins, 0 if none moves.
  std::size_t vertices() const;
  /// Returns the meshes of the model, with skins and morph targets posed for frame `frame` of `frames` frames that show
  /// the animation once. Valid until the next call.
  Result<std::span<const Mesh>> at(std::uint32_t frame, std::uint32_t frames);
  /// Returns meshes that have the positions of many frames, for results that depend on all frames. Valid until the next
  /// call.
  Result<std::span<const Mesh>> all_poses();

 private:
  bool moves_joints() const { return !joints_.tracks.empty() && !model_.skins.empty(); }
  bool moves_weights() const { return !weight_animation_.tracks.empty() && !model_.morphs.empty(); }
  /// Returns the memory of a mesh that moves.
  MovedVertices memory_of(std::size_t mesh);
  Result<Done> move_morphs(std::uint32_t milliseconds);
  Result<Done> move_skins(std::uint32_t milliseconds);
  /// Returns the joint or vertex that the animation moves too far, for a skin that could not be posed.
  std::string too_far(const Skin& skin, const Status& status);
  Failure refused(std::uint32_t milliseconds, const std::string& what) const;

  const Model& model_;
  Animation joints_;
  WeightAnimation weight_animation_;
  std::string file_;
  std::vector<Mesh> meshes_;
  std::map<std::size_t, MeshData> moved_;  ///< by mesh
  std::map<std::size_t, std::vector<Position>> all_;
  std::vector<JointPose> pose_;
  std::vector<Transform> work_;
  std::vector<MorphWeight> weights_;
};

}  // namespace zstrip::sim
