// Moves a scene at rest frame by frame, as boards do. Used to place baked blobs and trees.
#pragma once

#include <vector>

#include "render/stage.hpp"
#include "zstrip_scenes/baked_stage.hpp"

namespace zstrip::sim {

class TurnedParts {
 public:
  /// Returns frame `frame` of `frames`, which refers to these parts until the next call. Fails if a part is too far
  /// away to be rotated.
  Result<Staging> place(const scenes::AtRest& at_rest, const BspTree& tree, std::uint32_t frame, std::uint32_t frames) {
    if (frame % frames == 0 && at_rest.animation.tracks.empty()) return Staging{at_rest.scene, at_rest.camera, tree};
    if (!scenes::can_turn(at_rest)) {
      return Failure{ExitStatus::input, "what turns in the baked scene is too far away for it; render one frame"};
    }
    instances_.resize(at_rest.scene.instances.size());
    lines_.resize(at_rest.scene.lines.size());
    const scenes::BakedFrame staged = scenes::stage(at_rest, frame, frames, {.instances = instances_, .lines = lines_});
    return Staging{staged.scene, staged.camera, tree};
  }

 private:
  std::vector<Instance> instances_;
  std::vector<LineSet> lines_;
};

}  // namespace zstrip::sim
