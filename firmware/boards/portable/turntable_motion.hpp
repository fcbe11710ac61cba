// A built-in scene on the turntable: one of the motions that scene_player.hpp shows.
#pragma once

#include <cstdint>

#include "zstrip/plan/plan.hpp"
#include "zstrip_scenes/stage.hpp"

namespace zstrip::board {

/// Frame n of a turn in `frames_per_turn`, planned for `view` within `budget`.
template <const scenes::BuiltIn& scene, View view, Budget budget, std::uint32_t frames_per_turn = 64>
class TurntableMotion {
 public:
  static constexpr std::uint32_t kFrames = frames_per_turn;
  static constexpr View kView = view;
  static constexpr Effects kEffects = effects_of(scene.scene, scene.camera);
  static constexpr PlanResult kPlanned = plan(scene.counts, kView, kEffects, budget);
  static_assert(kPlanned.status, "the scene does not fit the budget");
  static constexpr Plan kPlan = kPlanned.plan;

  static constexpr const char* name() { return scene.name; }
  void move_to(std::uint32_t frame) { stage(scene, staged_, frame, frames_per_turn, kView); }
  const Scene& scene_now() const { return staged_.scene; }
  const Camera& camera_now() const { return staged_.camera; }

 private:
  scenes::Staged staged_;
};

}  // namespace zstrip::board
