// Sets a baked scene, from a header or a blob, in motion. Boards, zstrip-panel and the host command all use these
// functions, so that frame n is the same picture everywhere.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "zstrip/animation.hpp"
#include "zstrip/camera.hpp"
#include "zstrip/levels.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/scene/turn.hpp"
#include "zstrip_scenes/stage.hpp"

namespace zstrip::scenes {

/// A scene at frame 0, and its motion: the animation, or the rotation if there are no tracks.
struct AtRest {
  Scene scene;
  Camera camera;
  Animation animation{};
  Turn turn{};
  std::span<const DetailLevel> levels{};  ///< levels of detail; empty: instances keep their meshes
};

/// The data that must be in RAM. All other data stays constant.
struct MovedParts {
  std::span<Instance> instances;  ///< as many as the scene has
  std::span<LineSet> lines{};     ///< as many as the scene has, if turns_lines
};

/// One frame, ready for begin_frame.
struct BakedFrame {
  Scene scene;
  Camera camera;
};

constexpr bool turns_lines(const Animation& animation, const Turn& turn) {
  return animation.tracks.empty() && turn.what == Turning::instances_and_lines;
}

/// True if all rotated parts are near enough to the origin to rotate. An animation has no such limit.
inline bool can_turn(const AtRest& baked) {
  if (!baked.animation.tracks.empty() || baked.turn.what == Turning::nothing) return true;
  if (baked.turn.what == Turning::camera) return can_turn(baked.camera);
  const auto can = [](const auto& placed) { return can_turn(placed.transform); };
  return std::ranges::all_of(baked.scene.instances.subspan(baked.turn.still_instances), can) &&
         (!turns_lines(baked.animation, baked.turn) || std::ranges::all_of(baked.scene.lines, can));
}

/// Chooses the levels of detail of a frame of `at_rest`, whose instances then are `instances`.
inline void choose_levels(std::span<const DetailLevel> levels, const Scene& at_rest, std::span<Instance> instances,
                          BakedFrame& staged) {
  if (levels.empty()) return;
  if (staged.scene.instances.data() != instances.data()) {
    std::ranges::copy(staged.scene.instances, instances.begin());
    staged.scene.instances = instances;
  }
  zstrip::choose_levels(levels, at_rest, staged.camera, instances);
}

/// Moves the scene as stage() does, without levels of detail.
inline BakedFrame move(const AtRest& baked, std::uint32_t frame, std::uint32_t frames, const MovedParts& parts) {
  BakedFrame staged{baked.scene, baked.camera};
  const auto lend_instances = [&] {
    std::ranges::copy(baked.scene.instances, parts.instances.begin());
    staged.scene.instances = parts.instances;
  };
  const auto turn = [&](auto& placed) { placed.transform = turned(placed.transform, frame, frames); };
  if (!baked.animation.tracks.empty()) {
    lend_instances();
    pose(baked.animation, time_of_frame(baked.animation, frame, frames), parts.instances);
    return staged;
  }
  if (baked.turn.what == Turning::nothing) return staged;
  if (baked.turn.what == Turning::camera) {
    staged.camera = turned(baked.camera, frame, frames);
    return staged;
  }
  lend_instances();
  std::ranges::for_each(parts.instances.subspan(baked.turn.still_instances), turn);
  if (turns_lines(baked.animation, baked.turn)) {
    std::ranges::copy(baked.scene.lines, parts.lines.begin());
    std::ranges::for_each(parts.lines, turn);
    staged.scene.lines = parts.lines;
  }
  return staged;
}

/// Returns frame `frame` of `frames` (> 0) that show the animation once, or else a full rotation, for which can_turn()
/// must be true except for frame 0. The scene reads `parts`.
inline BakedFrame stage(const AtRest& baked, std::uint32_t frame, std::uint32_t frames, const MovedParts& parts) {
  BakedFrame staged = move(baked, frame, frames, parts);
  choose_levels(baked.levels, baked.scene, parts.instances, staged);
  return staged;
}

}  // namespace zstrip::scenes
