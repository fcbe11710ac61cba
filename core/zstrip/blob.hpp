// A baked scene in one block of bytes (`zstrip bake MODEL -o scene.zsc`), used in place: in flash, or in a file in
// memory. docs/formats.md defines the format.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip/animation.hpp"
#include "zstrip/camera.hpp"
#include "zstrip/clips.hpp"
#include "zstrip/effects.hpp"
#include "zstrip/levels.hpp"
#include "zstrip/morph.hpp"
#include "zstrip/overlay.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/scene/bsp_tree.hpp"
#include "zstrip/scene/turn.hpp"
#include "zstrip/skin.hpp"
#include "zstrip/status.hpp"
#include "zstrip/view.hpp"

namespace zstrip {

inline constexpr std::uint8_t kSceneBlobVersion = 6;  ///< the latest version that is read
/// The earliest version that is read: bake earlier blobs again. Blobs without morph targets are written as this
/// version, for programs that do not know later ones.
inline constexpr std::uint8_t kFirstSceneBlobVersion = 5;
inline constexpr std::uint32_t kSceneBlobAlignment = 4;  ///< bytes, for the blob's first byte

/// The effects that a picture may be baked for in addition to those of scene and view. The index is the number that a
/// blob stores for them. Entries are empty where blob_layout::is_gone is true.
inline constexpr Effects kPictureEffects[] = {{},
                                              effect::perspective_affine,
                                              effect::perspective_8,
                                              effect::perspective_1,
                                              effect::depth_float,
                                              {},
                                              effect::depth_24};

/// The contents of a blob. `scene` reads the blob and the memory lent to open_scene_blob: both must outlive it,
/// unchanged.
struct SceneBlob {
  Scene scene;            ///< has passed validate()
  Camera camera;          ///< the camera of the baked picture
  View view;              ///< the picture for which the camera was placed
  BspTree tree{};         ///< BSP tree of the scene's only instance, for VisibilityOptions::tree; no nodes if none was
                          ///< baked
  Animation animation{};  ///< animation of the scene's instances, which must be copied into RAM to move; empty: no
                          ///< motion
  Turn turn{};            ///< motion over several frames, used if the animation is empty
  const Camera* turning_camera = nullptr;  ///< the camera for several frames, in the blob; null: `camera` is used for
                                           ///< them, too
  Effects effects{};                       ///< the effects that the picture was baked for: one of kPictureEffects
  std::span<const Clip> clips{};           ///< if there are some, `animation` is that of the first one's instances, and
                                           ///< `turn` moves nothing
  std::span<const Skin> skins{};           ///< of meshes of the scene; they have the same joints
  MovedSkins moved{};                      ///< one Skinning a skin, to which the scene's meshes refer: for pose_clips
  MovedMorphs morphs{};                    ///< morph targets of meshes of the scene, for pose_clips
  std::span<const ClipEvent> events{};     ///< of the clips, or of `animation` as clip 0; clips ascend, and their times
  std::span<const DetailLevel> levels{};   ///< for choose_levels: the scene's instances have their own meshes
  std::uint32_t memory_bytes = 0;          ///< of the lent memory, that are in use

  /// Returns the camera for a motion of `frames` frames.
  constexpr const Camera& camera_for(std::uint32_t frames) const {
    return frames > 1 && turning_camera != nullptr ? *turning_camera : camera;
  }
};

/// Returns the bytes to lend for the tables of this many meshes, textures, sets of lines and of edges, images, fonts
/// and labels: these tables hold pointers, which exist only at run time. Vertices, triangles, segments, edges, texels,
/// materials, instances, lights, keyframes, nodes of the tree, sprites, coverage, glyphs and text are not copied.
constexpr std::size_t scene_blob_memory(std::uint32_t meshes, std::uint32_t textures, std::uint32_t lines = 0,
                                        std::uint32_t edges = 0, std::uint32_t images = 0, std::uint32_t fonts = 0,
                                        std::uint32_t labels = 0) {
  static_assert(alignof(Mesh) == alignof(Texture) && alignof(Mesh) == alignof(LineSet) &&
                alignof(Mesh) == alignof(EdgeSet) && alignof(Mesh) == alignof(Overlay) &&
                alignof(Mesh) == alignof(OverlayImage) && alignof(Mesh) == alignof(Font) &&
                alignof(Mesh) == alignof(Label));
  const std::size_t overlay = images != 0 || fonts != 0 ? sizeof(Overlay) : 0;
  return std::size_t{meshes} * sizeof(Mesh) + std::size_t{textures} * sizeof(Texture) +
         std::size_t{lines} * sizeof(LineSet) + std::size_t{edges} * sizeof(EdgeSet) + overlay +
         std::size_t{images} * sizeof(OverlayImage) + std::size_t{fonts} * sizeof(Font) +
         std::size_t{labels} * sizeof(Label);
}

/// The numbers of a blob's skins, joints, clips and morph targets, and of the vertices that move at a time.
struct CharacterCounts {
  std::uint32_t skins = 0;      ///< tables of skins, one a mesh that bends
  std::uint32_t joints = 0;     ///< joints of all skins together
  std::uint32_t clips = 0;      ///< named animations
  std::uint32_t positions = 0;  ///< vertices of the largest meshlet of all skins, which share the memory for them
  std::uint32_t normals = 0;    ///< vertices of the largest meshlet of a skin with normals
  std::uint32_t morphs = 0;     ///< meshes with morph targets
  std::uint32_t targets = 0;    ///< morph targets of all these meshes
  std::uint32_t weights = 0;    ///< weights of all targets
  std::uint64_t morphed_positions = 0;  ///< vertices of all meshes with morph targets
  std::uint64_t morphed_normals = 0;    ///< their normals
  std::uint64_t morphed_meshlets = 0;   ///< their meshlets
};

/// Returns the bytes to lend in addition to scene_blob_memory, for tables, the pose, matrices, a moved meshlet, weights
/// and morphed meshes.
constexpr std::uint64_t character_memory(const CharacterCounts& counts) {
  static_assert(alignof(Skin) == alignof(Mesh) && alignof(Skinning) == alignof(Mesh) && alignof(Clip) == alignof(Mesh));
  static_assert(alignof(MovedMorph) == alignof(Mesh) && alignof(MorphTarget) == alignof(Mesh));
  const std::uint64_t matrices = std::uint64_t{counts.skins} * counts.joints;
  return std::uint64_t{counts.skins} * (sizeof(Skin) + sizeof(Skinning)) + std::uint64_t{counts.clips} * sizeof(Clip) +
         matrices * sizeof(Transform) + std::uint64_t{counts.joints} * sizeof(JointPose) +
         std::uint64_t{counts.positions} * sizeof(Position) + std::uint64_t{counts.normals} * sizeof(Normal) +
         std::uint64_t{counts.morphs} * (sizeof(MovedMorph) + sizeof(Mesh)) +
         std::uint64_t{counts.targets} * sizeof(MorphTarget) + std::uint64_t{counts.weights} * sizeof(MorphWeight) +
         counts.morphed_positions * sizeof(Position) + counts.morphed_normals * sizeof(Normal) +
         counts.morphed_meshlets * sizeof(Meshlet);
}

/// Bytes, for the memory that is lent to open_scene_blob.
inline constexpr std::size_t kSceneBlobMemoryAlignment = alignof(Mesh);

/// Checks the whole `blob`, with checksum, offsets and scene (validate), and then makes `opened` a view of it. On an
/// error `opened` keeps its value. Skins and morph targets are in the pose as they were modelled until pose_clips.
/// Any bytes are safe. Time: linear in the bytes of `blob` and `memory`, and in the elements that all records name:
/// records may share triangles or keys, which are checked for each of them. docs/formats.md has the worst case, which
/// takes minutes on a microcontroller. Errors: blob_alignment; blob_damaged (`needed`: offset of the wrong byte, or the
/// offset behind the last byte if bytes are missing); blob_version (`needed`: the blob's version, `available`: the
/// latest version that is read); blob_section (`needed`: tag of a required section that this program does not know, its
/// first letter in the highest byte); blob_depth (`needed`: number of a depth format that was removed); blob_memory
/// (`needed`, `available`: bytes of `memory`); camera; skin (`needed`: the mesh of lines, edges or CSG that joints
/// move, or as in validate, also of a Morph); and all errors of validate.
Status open_scene_blob(std::span<const std::byte> blob, std::span<std::byte> memory, SceneBlob& opened);

/// Moves the morph targets and the joints of an open blob by the clips that play, as pose_clips of clips.hpp does for
/// each, before the frame that shows them.
inline Status pose_clips(const SceneBlob& blob, std::span<const PlayedClip> played) {
  const Status morphed = pose_clips(blob.clips, played, blob.morphs);
  const Status posed = pose_clips(blob.clips, played, blob.moved);
  return morphed ? posed : morphed;
}

}  // namespace zstrip
