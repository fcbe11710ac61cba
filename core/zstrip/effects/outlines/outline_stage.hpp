// The outlines of a frame: hulls, as separate instances, behind the instances that they outline.
#pragma once

#include <span>

#include "zstrip/effects/outlines/effect.hpp"
#include "zstrip/effects/outlines/outline.hpp"
#include "zstrip/effects/stage.hpp"
#include "zstrip/visibility/traits.hpp"

namespace zstrip::detail::outlines {

/// A scene with the hulls of its outlines as its last instances.
struct OutlinedScene {
  Scene scene;                  ///< without outlines, but with the index of the first one
  std::uint32_t outline_count;  ///< number of the caller's outlines
  std::uint32_t instances;      ///< number of the caller's instances

  std::span<const Outline> outlines() const { return {scene.outlines.data(), outline_count}; }
};
static_assert(sizeof(OutlinedScene) <= Effect::kSceneBytes);

inline OutlinedScene* outlined_of(const FrameState& frame) { return effect_block(frame).at<Effect, OutlinedScene>(); }

/// Adds the hulls of outlines to the scene as instances, and removes the outlines. Afterwards the instances lie in the
/// effects' part of the arena.
void add_hulls(const FrameState& frame, Scene& scene);
/// Extends `reach` by the hulls. `view` is the picture of samples if pixels have several.
void extend(DistanceRange& reach, const OutlinedScene& outlined, const Camera& camera, const View& view);
/// Makes outlines of the hulls, which are compiled as instances.
void make_outlines(FrameState& frame, const Camera& camera);

struct Stage : NoStage {
  static constexpr Effects kEffects = effect::outlines;
  static constexpr bool kChangesScene = true;

  template <Effects effects>
  static Status change_scene(const FrameState& frame, Scene& drawn, const FrameRequest& request, const Camera&) {
    if (request.called_for.has(effect::outlines)) add_hulls(frame, drawn);
    return {};
  }
  template <Effects effects>
  static void keep_scene(FrameState& frame, const FrameRequest& request) {
    if (request.called_for.has(effect::outlines)) frame.scene = &outlined_of(frame)->scene;
  }
  template <Effects effects>
  static void extend_reach(const FrameState& frame, const Scene&, const FrameRequest& request, DistanceRange& reach) {
    if (!request.called_for.has(effect::outlines)) return;
    extend(reach, *outlined_of(frame), request.camera, request.view);
  }
  template <Effects effects>
  static Status prepare_geometry(FrameState& frame, const Scene&, const FrameRequest& request) {
    if (request.called_for.has(effect::outlines)) make_outlines(frame, request.camera);
    return {};
  }
  /// A hull shows only its far side, even if instances are drawn double-sided.
  template <Effects effects>
  static Status prepare(FrameState& frame, const FrameRequest&) {
    if constexpr (methods::culls(effects)) {
      for (CompiledInstance& instance : std::span(frame.instances, frame.scene->instances.size())) {
        if (is_outline(instance)) instance.double_sided = false;
      }
    }
    return {};
  }
};

}  // namespace zstrip::detail::outlines
