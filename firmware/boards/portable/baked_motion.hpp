// A scene of one's own, baked by `zstrip bake`, animated or turning: one of the motions that scene_player.hpp shows. ZSTRIP_SCENE
// names its header.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>

#include "baked_scene.hpp"
#include "zstrip/scene/animation.hpp"
#include "zstrip_scenes/stage.hpp"

namespace zstrip::board {

class BakedMotion {
 public:
  static constexpr std::uint32_t kFrames = 64;
  static constexpr View kView = baked::kView;
  static constexpr Effects kEffects = baked::kEffects;
  static constexpr Plan kPlan = baked::kPlan;

  static constexpr const char* name() { return "baked"; }
  /// The scene's animation in as many frames as a turn has; what has none turns.
  void move_to(std::uint32_t frame) {
    if constexpr (!baked::kAnimation.tracks.empty()) {
      std::copy(std::begin(baked::kInstances), std::end(baked::kInstances), instances_.begin());
      pose(baked::kAnimation, time_of_frame(baked::kAnimation, frame, kFrames), instances_);
    } else {
      std::transform(std::begin(baked::kInstances), std::end(baked::kInstances), instances_.begin(),
                     [frame](Instance instance) {
                       instance.transform = scenes::turned(instance.transform, frame, kFrames);
                       return instance;
                     });
    }
    scene_ = baked::kScene;
    scene_.instances = instances_;
  }
  const Scene& scene_now() const { return scene_; }
  const Camera& camera_now() const { return baked::kCamera; }

 private:
  // What moves lies in RAM; everything else stays in flash.
  std::array<Instance, std::size(baked::kInstances)> instances_;
  Scene scene_;
};

}  // namespace zstrip::board
