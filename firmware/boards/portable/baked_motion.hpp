// Your own scene, baked by `zstrip bake`, with its animation or rotation, as a motion for scene_player.hpp.
// ZSTRIP_SCENE names its header.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include "baked_scene.hpp"
#include "zstrip/fixed_renderer.hpp"
#include "zstrip/renderer.hpp"
#include "zstrip_scenes/baked_stage.hpp"

/// Used if the header has no skins. It lies outside of the header's namespace, because an inner namespace would hide
/// it.
namespace baked_without_skins {
template <class Time>
constexpr zstrip::Status pose_skins(Time) {
  return {};
}
}  // namespace baked_without_skins

namespace zstrip::board {

/// True if FixedRenderer can draw the scene: no lines rotate, and it needs none of the effects that only Renderer
/// supports.
inline constexpr bool kBakedIsFixed =
    !(scenes::turns_lines(baked::kAnimation, baked::kTurn) && !baked::kScene.lines.empty()) &&
    baked::kEffects.methods == 0 && !baked::kEffects.any(effect::depth_ranges | effect::supersampled);

// These are templates, so that no code is generated for the unused one.

/// Scene and picture are constants; only instances are in RAM.
template <const Scene& scene>
struct FixedBakedScene {
  using Drawing =
      FixedRenderer<scene, baked::kView, baked::kBudget, without(baked::kEffects, effects_of(scene, baked::kCamera)),
                    baked::kCamera.projection, baked::kCounts>;
  static scenes::MovedParts parts() { return {.instances = moving.instances()}; }
  static Status begin_frame(const scenes::BakedFrame& staged) { return renderer.begin_frame(staged.camera, moving); }
  static Status draw_strip(std::uint16_t strip, std::span<std::byte> pixels) {
    return renderer.draw_strip(strip, pixels.template first<Drawing::kStripBytes>());
  }

 private:
  static inline constinit typename Drawing::Moving moving{};
  static inline constinit Drawing renderer{};
};

/// Moving data is in RAM, all other data in flash.
template <const Scene& scene>
struct AnyBakedScene {
  static scenes::MovedParts parts() { return {.instances = instances, .lines = lines}; }
  static Status begin_frame(const scenes::BakedFrame& staged) {
    return renderer.begin_frame(staged.scene, staged.camera, baked::kView, baked::kPlan, arena);
  }
  static Status draw_strip(std::uint16_t strip, std::span<std::byte> pixels) {
    return renderer.draw_strip(strip, pixels);
  }

 private:
  static constexpr bool kMovesLines = scenes::turns_lines(baked::kAnimation, baked::kTurn);
  static inline constinit std::array<Instance, scene.instances.size()> instances{};
  static inline constinit std::array<LineSet, kMovesLines ? scene.lines.size() : 0> lines{};
  alignas(kArenaAlignment) static inline constinit std::array<std::byte, baked::kPlan.bytes()> arena{};
  static inline constinit Renderer<baked::kEffects> renderer{};
};

class BakedMotion {
 public:
  static constexpr std::uint32_t kFrames = 64;
  static constexpr View kView = baked::kView;
  static constexpr Plan kPlan = baked::kPlan;

  static constexpr const char* name() { return "baked"; }
  /// Shows the scene's animation in as many frames as a full rotation has; a scene without an animation rotates.
  static Status move_to(std::uint32_t frame) {
    staged =
        scenes::stage({baked::kScene, baked::kCamera, baked::kAnimation, baked::kTurn}, frame, kFrames, Baked::parts());
    using namespace baked_without_skins;
    using namespace baked;
    return pose_skins(time_of_frame(kAnimation, frame, kFrames));
  }
  static Status begin_frame() { return Baked::begin_frame(staged); }
  static Status draw_strip(std::uint16_t strip, std::span<std::byte> pixels) {
    return Baked::draw_strip(strip, pixels);
  }

 private:
  using Baked = std::conditional_t<kBakedIsFixed, FixedBakedScene<baked::kScene>, AnyBakedScene<baked::kScene>>;
  static inline constinit scenes::BakedFrame staged{};
};

}  // namespace zstrip::board
