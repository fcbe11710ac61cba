// The skins, morph targets and clips that `zstrip bake` writes.
#pragma once

#include <cstddef>
#include <set>
#include <vector>

#include "bake/baked_scene.hpp"
#include "cli/bake_command.hpp"
#include "cli/bake_kind.hpp"
#include "render/model_clip.hpp"
#include "render/stage.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// The parts of the output that joints move: of a header the chosen animation, of a blob all clips.
struct OutputSkins {
  BakedSkins skins;
  std::vector<ModelClip> clips;  ///< of a blob; empty: it has at most one animation, and that of instances
};

/// Returns the events of the clips, or without clips those of the stage's animation.
std::vector<ClipEvent> events_of(const std::vector<ModelClip>& clips, const Stage& stage);

/// Returns what moves in the output; `scene`: the stage's at rest. With `warn` says what stands still and why.
Result<OutputSkins> skins_of(BakeKind kind, const BakeArguments& arguments, Effects method, const Stage& stage,
                             const Scene& scene, bool warn);

/// Returns the meshes that move in the light, or whose tables a level of detail shares.
std::set<std::size_t> meshes_in_motion(const Staging& at_rest, const Animation& animation, const Turn& turn,
                                       const OutputSkins& output);

}  // namespace zstrip::sim
