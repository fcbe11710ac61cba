// The skins, clips and morph targets of a model, as a blob holds them.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "bake/baked_scene.hpp"
#include "bake/flash_bytes.hpp"
#include "import/model.hpp"
#include "render/model_clip.hpp"
#include "result.hpp"
#include "zstrip/clips.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/skin.hpp"

namespace zstrip::sim {

/// Owns the tables of skins, clips and morph targets, and the memory in which vertices move. All arguments must outlive
/// it.
class BlobCharacters {
 public:
  /// `skins`: of meshes of `scene`. The scene's meshes may be in any pose.
  BlobCharacters(const Scene& scene, const BakedSkins& skins, std::span<const ModelClip> clips);
  BlobCharacters(const BlobCharacters&) = delete;
  BlobCharacters& operator=(const BlobCharacters&) = delete;

  /// Poses joints and morph targets at many times of each clip, finally at the start of the first one. The failure's
  /// message starts with "the animation".
  Result<Done> pose_all();

  /// The scene with meshes as their morph targets were posed last, which their skins move while they are drawn.
  const Scene& scene() const { return scene_; }
  std::span<const Skin> skins() const { return skins_; }
  std::span<const Clip> clips() const { return clips_; }
  std::span<const MovedMorph> morphs() const { return morphs_; }

  /// Returns the RAM of the vertices that move, of joints and of weights: parts of character_memory.
  SkinRam ram() const { return skin_ram(skinnings_, pose_.size(), morphs_, weights_.size()); }
  /// Returns the bytes of the tables with addresses of 32 bits: the rest of character_memory.
  std::uint64_t table_bytes() const;
  /// Returns the bytes of all keyframes and tracks in the blob.
  std::uint64_t keyframe_bytes() const;

 private:
  std::vector<Mesh> meshes_;
  Scene scene_;
  std::vector<Skin> skins_;
  std::vector<Skinning> skinnings_;
  std::vector<Clip> clips_;
  std::vector<Transform> matrices_;
  std::vector<JointPose> pose_;
  std::vector<Position> positions_;
  std::vector<Normal> normals_;
  std::vector<Mesh> bases_;  ///< meshes with morph targets, as they were modelled
  std::vector<MovedMorph> morphs_;
  std::vector<MeshData> morphed_;
  std::vector<MorphWeight> weights_;
};

}  // namespace zstrip::sim
