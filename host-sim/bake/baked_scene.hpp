// What is baked: a scene as it stands, the picture that it was placed for, and the plan of that picture.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>

#include "import/model.hpp"
#include "zstrip/animation.hpp"
#include "zstrip/camera.hpp"
#include "zstrip/effects.hpp"
#include "zstrip/plan.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/scene/bsp_tree.hpp"
#include "zstrip/scene/turn.hpp"
#include "zstrip/view.hpp"

namespace zstrip::sim {

/// Meshes of the scene that joints move.
struct BakedSkins {
  std::span<const ModelSkin> meshes;  ///< empty: nothing bends
  std::span<const Joint> joints;      ///< of all of them
  std::span<const JointPose> rest;
  Animation animation;  ///< of the joints

  /// The mesh as it was modelled, where it is one of these, else null.
  const ModelSkin* find(std::size_t mesh) const {
    const auto found = std::ranges::find(meshes, mesh, &ModelSkin::mesh);
    return found == meshes.end() ? nullptr : &*found;
  }
};

/// Passes validate(); its views must outlive it.
struct BakedScene {
  std::string source;  ///< what it was made of, without folders, for comments
  Scene scene;
  Camera camera;
  Animation animation;  ///< empty: what `turn` selects moves
  View view;
  /// Those that scene and view call for, effect::bins if the plan needs it, the visibility method, one of
  /// effect::perspective_runs or of effect::depth_formats, and effect::unclipped.
  Effects effects;
  Budget budget;  ///< with the strips of `plan`: the same plan comes out of it again
  Plan plan;
  BspTree tree{};  ///< with method::bsp
  Turn turn{};
  BakedSkins skins{};
  std::string unclipped_where{};  ///< with effect::unclipped: the poses for which that was checked, in words
};

}  // namespace zstrip::sim
