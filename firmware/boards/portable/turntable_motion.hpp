// A built-in scene on the turntable, drawn with a preset: one of the motions that scene_player.hpp shows.
#pragma once

#include <cstddef>
#include <cstdint>

#include "zstrip/plan.hpp"
#include "zstrip_scenes/stage.hpp"

namespace zstrip::board {

/// `budget` with the preset's way of drawing. How many rows a strip has depends on the board's memory, unless the
/// preset has fewer than the usual ones: then few rows are its purpose.
constexpr Budget with_quality(Budget budget, const Quality& preset) {
  budget.modes = preset.budget.modes;
  if (preset.budget.strip_rows < quality::balanced.budget.strip_rows) budget.strip_rows = preset.budget.strip_rows;
  return budget;
}

/// Whether a scene that is in flash as it is suits the preset: flat, and no mesh worth simplifying.
constexpr bool suits(const scenes::BuiltIn& scene, const Quality& preset) {
  constexpr std::size_t kWorthSimplifying = 200;  // triangles
  if (!preset.smooth && effects_of(scene.scene, scene.camera).has(effect::gouraud)) return false;
  if (preset.detail_percent == 100) return true;
  for (const Mesh& mesh : scene.scene.meshes) {
    if (mesh.triangles.size() >= kWorthSimplifying) return false;
  }
  return true;
}

/// Frame n of a turn in `frames_per_turn`, planned for `view` within `budget`, drawn with `preset`, one of
/// zstrip/plan.hpp (what each costs and buys: docs/accuracy.md).
template <const scenes::BuiltIn& scene, View view, Budget budget, std::uint32_t frames_per_turn = 64,
          const Quality& preset = quality::balanced>
class TurntableMotion {
 public:
  static constexpr std::uint32_t kFrames = frames_per_turn;
  static constexpr View kView = view;
  static constexpr Effects kEffects = effects_of(scene.scene, scene.camera) | preset.effects;
  static_assert(suits(scene, preset), "the scene is smooth, or has meshes to simplify: bake it for this preset");
  static constexpr PlanResult kPlanned = plan(scene.counts, kView, kEffects, with_quality(budget, preset));
  static_assert(kPlanned.status, "the scene does not fit the budget");
  static constexpr Plan kPlan = kPlanned.plan;

  static constexpr const char* name() { return scene.name; }
  Status move_to(std::uint32_t frame) {
    stage(scene, staged_, frame, frames_per_turn, kView);
    return {};
  }
  const Scene& scene_now() const { return staged_.scene; }
  const Camera& camera_now() const { return staged_.camera; }

 private:
  scenes::Staged staged_;
};

}  // namespace zstrip::board
