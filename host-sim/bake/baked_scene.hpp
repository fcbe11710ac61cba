// The input of the output formats: a scene at rest, the picture for which it was placed, and the plan of that picture.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>

#include "import/model.hpp"
#include "zstrip/animation.hpp"
#include "zstrip/camera.hpp"
#include "zstrip/clips.hpp"
#include "zstrip/effects.hpp"
#include "zstrip/levels.hpp"
#include "zstrip/plan.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/scene/bsp_tree.hpp"
#include "zstrip/scene/turn.hpp"
#include "zstrip/view.hpp"

namespace zstrip::sim {

class BlobCharacters;

/// Meshes of the scene that joints or morph targets move.
struct BakedSkins {
  std::span<const ModelSkin> meshes;  ///< empty: no mesh has a skin
  std::span<const Joint> joints;      ///< of all these meshes
  std::span<const JointPose> rest;
  Animation animation;                   ///< of the joints
  std::span<const ModelMorph> morphs{};  ///< empty: no mesh has morph targets that move
  std::size_t weights = 0;               ///< of all these targets
  WeightAnimation weight_animation{};

  /// True if the vertices of a mesh move.
  bool move() const { return !meshes.empty() || !morphs.empty(); }

  /// Returns the mesh as it was modelled, or null if no joint moves it.
  const ModelSkin* find(std::size_t mesh) const {
    const auto found = std::ranges::find(meshes, mesh, &ModelSkin::mesh);
    return found == meshes.end() ? nullptr : &*found;
  }
  /// Returns the morph targets of the mesh, or null if none moves it.
  const ModelMorph* find_morph(std::size_t mesh) const {
    const auto found = std::ranges::find(morphs, mesh, &ModelMorph::mesh);
    return found == morphs.end() ? nullptr : &*found;
  }
  /// Returns the mesh before anything moves it, or null if nothing does.
  const Mesh* unmoved(std::size_t mesh) const {
    if (const ModelSkin* const skin = find(mesh)) return &skin->bind;
    const ModelMorph* const morph = find_morph(mesh);
    return morph == nullptr ? nullptr : &morph->base;
  }
};

/// Passes validate(); the data of its views must outlive it.
struct BakedScene {
  std::string source;  ///< name of the source, without folders, for comments
  Scene scene;
  Camera camera;
  Animation animation;  ///< empty: `turn` selects the motion
  View view;
  /// The effects that scene and view need, effect::bins if the plan needs it, the visibility method, one of
  /// effect::perspective_runs or of effect::depth_formats, and effect::unclipped.
  Effects effects;
  Budget budget;  ///< with the strips of `plan`: planning with it gives the same plan
  Plan plan;
  BspTree tree{};  ///< for method::bsp
  Turn turn{};
  BakedSkins skins{};                          ///< of a header
  const BlobCharacters* characters = nullptr;  ///< of a blob; null: nothing bends, and there is one animation or none
  std::span<const ClipEvent> events{};         ///< of a blob's clips; of a header's motion as clip 0
  std::size_t edges_left_out = 0;              ///< by ShownEdges
  std::span<const DetailLevel> levels{};       ///< of detail; `scene` has their meshes
  std::string unclipped_where{};               ///< with effect::unclipped: the poses that were checked, as text
};

}  // namespace zstrip::sim
