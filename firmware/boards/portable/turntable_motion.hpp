// A built-in scene on the turntable, drawn with a preset, as a motion for scene_player.hpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip/effects/exclusions.hpp"
#include "zstrip/fixed_renderer.hpp"
#include "zstrip/plan.hpp"
#include "zstrip_scenes/in_front.hpp"
#include "zstrip_scenes/stage.hpp"

namespace zstrip::board {

/// Returns `budget` with the preset's modes. The number of rows depends on the board's memory, unless the preset has
/// fewer rows than the default: then few rows are its purpose.
constexpr Budget with_quality(Budget budget, const Quality& preset) {
  budget.modes = preset.budget.modes;
  if (preset.budget.strip_rows < quality::balanced.budget.strip_rows) budget.strip_rows = preset.budget.strip_rows;
  return budget;
}

/// True if the preset needs no change of a scene in flash: it shades flat like the scene, and no mesh is worth
/// simplifying.
constexpr bool suits(const scenes::BuiltIn& scene, const Quality& preset) {
  constexpr std::size_t kWorthSimplifying = 200;  // triangles
  if (!preset.smooth && effects_of(scene.scene, scene.camera).has(effect::gouraud)) return false;
  if (preset.detail_percent == 100) return true;
  for (const Mesh& mesh : scene.scene.meshes) {
    if (mesh.triangles.size() >= kWorthSimplifying) return false;
  }
  return true;
}

/// Returns the effects of the preset, and effect::unclipped if the scene stays in front of the camera in all frames.
template <const scenes::BuiltIn& scene, View view, const Quality& preset>
constexpr Effects effects_beside() {
  constexpr bool kInFront = scenes::stays_in_front(scene, view);
  const Effects unclipped = preset.effects | effect::unclipped;
  return kInFront && effects_agree(effects_of(scene.scene, scene.camera) | unclipped) ? unclipped : preset.effects;
}

template <const scenes::BuiltIn& built_in>
inline constexpr Scene kSceneOf = built_in.scene;

/// Shows frame n of a rotation in `frames_per_turn` frames, planned for `view` within `budget`, drawn with `preset`,
/// one of zstrip/plan.hpp (docs/accuracy.md has costs and benefits). Scene and picture are constants; only the rotated
/// data is in RAM: instances, or the camera.
template <const scenes::BuiltIn& built_in, View view, Budget budget, std::uint32_t frames_per_turn = 64,
          const Quality& preset = quality::balanced>
class TurntableMotion {
 public:
  static constexpr std::uint32_t kFrames = frames_per_turn;
  static constexpr View kView = view;
  static_assert(suits(built_in, preset), "the scene is smooth, or has meshes to simplify: bake it for this preset");
  using Drawing = FixedRenderer<kSceneOf<built_in>, kView, with_quality(budget, preset),
                                effects_beside<built_in, view, preset>(), Projection::perspective, built_in.counts>;
  static constexpr Plan kPlan = Drawing::kPlan;

  static constexpr const char* name() { return built_in.name; }
  static Status move_to(std::uint32_t frame) {
    if constexpr (built_in.turns == scenes::Turns::camera) {
      camera = scenes::turned(scenes::fitted_camera(built_in, kView), frame, frames_per_turn);
    } else {
      for (std::size_t i = 0; i < built_in.scene.instances.size(); ++i) {
        moving.instances()[i].transform = scenes::turned(built_in.scene.instances[i].transform, frame, frames_per_turn);
      }
    }
    return {};
  }
  static Status begin_frame() {
    if constexpr (built_in.turns == scenes::Turns::camera) {
      return renderer.begin_frame(camera);
    } else {
      return renderer.begin_frame(kCamera, moving);
    }
  }
  static auto frame() { return renderer.frame(); }
  static const Camera& camera_of_frame() {
    if constexpr (built_in.turns == scenes::Turns::camera) {
      return camera;
    } else {
      return kCamera;
    }
  }
  static Status draw_strip(std::uint16_t strip, std::span<std::byte> pixels) {
    return renderer.draw_strip(strip, pixels.template first<Drawing::kStripBytes>());
  }

 protected:
  static constexpr Camera kCamera = scenes::fitted_camera(built_in, kView);
  // Only one of the first two members is used and linked.
  static inline constinit Camera camera{};
  static inline constinit typename Drawing::Moving moving{};
  static inline constinit Drawing renderer{};
};

}  // namespace zstrip::board
