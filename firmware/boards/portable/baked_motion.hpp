// A scene of one's own, baked by `zstrip bake`, animated or turning: one of the motions that scene_player.hpp shows.
// ZSTRIP_SCENE names its header.
#pragma once

#include <array>
#include <cstdint>

#include "baked_scene.hpp"
#include "zstrip_scenes/baked_stage.hpp"

/// What is found where the header has no skins: beside its namespace, because an inner one would hide it.
namespace baked_without_skins {
template <class Time>
constexpr zstrip::Status pose_skins(Time) {
  return {};
}
}  // namespace baked_without_skins

namespace zstrip::board {

class BakedMotion {
 public:
  static constexpr std::uint32_t kFrames = 64;
  static constexpr View kView = baked::kView;
  static constexpr Effects kEffects = baked::kEffects;
  static constexpr Plan kPlan = baked::kPlan;

  static constexpr const char* name() { return "baked"; }
  /// The scene's animation in as many frames as a turn has; what has none turns.
  Status move_to(std::uint32_t frame) {
    staged_ = scenes::stage({baked::kScene, baked::kCamera, baked::kAnimation, baked::kTurn}, frame, kFrames,
                            {.instances = instances_, .lines = lines_});
    using namespace baked_without_skins;
    using namespace baked;
    return pose_skins(time_of_frame(kAnimation, frame, kFrames));
  }
  const Scene& scene_now() const { return staged_.scene; }
  const Camera& camera_now() const { return staged_.camera; }

 private:
  static constexpr bool kMovesLines = scenes::turns_lines(baked::kAnimation, baked::kTurn);

  // What moves lies in RAM; everything else stays in flash.
  std::array<Instance, baked::kScene.instances.size()> instances_;
  std::array<LineSet, kMovesLines ? baked::kScene.lines.size() : 0> lines_;
  scenes::BakedFrame staged_;
};

}  // namespace zstrip::board
