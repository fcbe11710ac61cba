// A built-in scene on the turntable: one of the motions that scene_player.hpp shows.
#pragma once

#include <cstdint>

#include "zstrip/plan/plan.hpp"
#include "zstrip/plan/quality.hpp"
#include "zstrip_scenes/stage.hpp"

namespace zstrip::board {

/// What all boards draw with (docs/accuracy.md): another preset here costs and buys what that page says.
inline constexpr const Quality& kQuality = quality::balanced;
static_assert(kQuality.smooth && kQuality.detail_percent == 100, "built-in scenes are in flash as they are");

/// `budget` with the preset's way of drawing; how many rows a strip has is for the board's memory to say.
constexpr Budget with_quality(Budget budget) {
  budget.modes = kQuality.budget.modes;
  return budget;
}

/// Frame n of a turn in `frames_per_turn`, planned for `view` within `budget`.
template <const scenes::BuiltIn& scene, View view, Budget budget, std::uint32_t frames_per_turn = 64>
class TurntableMotion {
 public:
  static constexpr std::uint32_t kFrames = frames_per_turn;
  static constexpr View kView = view;
  static constexpr Effects kEffects = effects_of(scene.scene, scene.camera) | kQuality.effects;
  static constexpr PlanResult kPlanned = plan(scene.counts, kView, kEffects, with_quality(budget));
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
