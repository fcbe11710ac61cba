// A baked scene as one piece of bytes (`zstrip bake MODEL -o scene.zsc`), used where it lies: in flash, in a file in
// memory. The format is in docs/formats.md.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip/animation.hpp"
#include "zstrip/camera.hpp"
#include "zstrip/effects.hpp"
#include "zstrip/overlay.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/scene/bsp_tree.hpp"
#include "zstrip/scene/turn.hpp"
#include "zstrip/status.hpp"
#include "zstrip/view.hpp"

namespace zstrip {

inline constexpr std::uint8_t kSceneBlobVersion = 5;     ///< the one that is read: others are to be baked again
inline constexpr std::uint32_t kSceneBlobAlignment = 4;  ///< of the blob's first byte

/// The effects that a picture may be baked for beside those of scene and view, in the order of a blob's numbers for
/// them; empty where blob_layout::is_gone.
inline constexpr Effects kPictureEffects[] = {{},
                                              effect::perspective_affine,
                                              effect::perspective_8,
                                              effect::perspective_1,
                                              effect::depth_float,
                                              {},
                                              effect::depth_24};

/// What a blob holds. `scene` reads the blob and the memory lent to open_scene_blob: both must outlive it, unchanged.
struct SceneBlob {
  Scene scene;            ///< has passed validate()
  Camera camera;          ///< from which it was baked
  View view;              ///< the picture for which the camera was placed
  BspTree tree{};         ///< of the scene's only instance, VisibilityOptions::tree; without nodes none was baked
  Animation animation{};  ///< of the scene's instances, which are to be copied into RAM for it; empty: nothing moves
  Turn turn{};            ///< what moves over several frames where the animation is empty
  const Camera* turning_camera = nullptr;  ///< instead of `camera` for such frames; null: the same. In the blob.
  Effects effects{};                       ///< what the picture was baked for: one of kPictureEffects

  /// The one for `frames` frames.
  constexpr const Camera& camera_for(std::uint32_t frames) const {
    return frames > 1 && turning_camera != nullptr ? *turning_camera : camera;
  }
};

/// Bytes to lend for the tables of this many meshes, textures, sets of lines and of edges, images, fonts and labels,
/// whose pointers exist only at run time. Vertices, triangles, segments, edges, texels, materials, instances,
/// lights, keyframes, nodes of the tree, sprites, coverage, glyphs and text are not copied.
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
/// Of the memory that is lent to open_scene_blob.
inline constexpr std::size_t kSceneBlobMemoryAlignment = alignof(Mesh);

/// Checks all of `blob`, checksum, offsets and scene (validate) included, and then makes `opened` a view of it. On an
/// error `opened` stays as it was. Time: linear in the blob's size. Any bytes are safe.
/// Errors: blob_alignment; blob_damaged (`needed`: the byte that is wrong; that after the last one if some are
/// missing); blob_version (`needed`: its version, `available`: the one that is read here); blob_section (`needed`: the
/// tag of a section that must be known and is not, its first letter in the highest byte); blob_depth (`needed`: the
/// number of a depth format that is gone); blob_memory (`needed`, `available`: bytes of `memory`); camera; and those of
/// validate.
Status open_scene_blob(std::span<const std::byte> blob, std::span<std::byte> memory, SceneBlob& opened);

}  // namespace zstrip
