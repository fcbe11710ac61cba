// Outlines of a frame: hulls behind what they outline, which are instances of their own.
#pragma once

#include "zstrip/effects/outlines/outline.hpp"
#include "zstrip/effects/stage.hpp"

namespace zstrip::detail::outlines {

/// Gives the scene its outlines' hulls as instances and takes the outlines away; all of it lies in the effects' part of
/// the arena then.
void add_hulls(const FrameState& frame, Scene& scene);
/// Extends a reach by the hulls. `view`: of samples where there are several.
void extend(DistanceRange& reach, const OutlinedScene& outlined, const Camera& camera, const View& view);
/// Makes outlines of the hulls, which have been compiled as instances.
void make_outlines(FrameState& frame, const Camera& camera);

struct Stage : NoStage {
  static constexpr Effects kEffects = effect::outlines;
  static constexpr bool kChangesScene = true;

  template <Effects effects>
  static Status change_scene(const FrameState& frame, Scene& drawn, const FrameRequest& request) {
    if (request.called_for.has(effect::outlines)) add_hulls(frame, drawn);
    return {};
  }
  template <Effects effects>
  static void keep_scene(FrameState& frame, const FrameRequest& request) {
    if (request.called_for.has(effect::outlines)) frame.scene = &effect_block(frame).outlined().scene;
  }
  template <Effects effects>
  static void extend_reach(const FrameState& frame, const Scene&, const FrameRequest& request, DistanceRange& reach) {
    if (!request.called_for.has(effect::outlines)) return;
    extend(reach, effect_block(frame).outlined(), request.camera, request.view);
  }
  template <Effects effects>
  static Status prepare_geometry(FrameState& frame, const Scene&, const FrameRequest& request) {
    if (request.called_for.has(effect::outlines)) make_outlines(frame, request.camera);
    return {};
  }
  /// Of a hull only the far side, also where front and back of all else are drawn.
  template <Effects effects>
  static Status prepare(FrameState& frame, const FrameRequest&) {
    if constexpr (effects.has(method::culling)) {
      for (CompiledInstance& instance : std::span(frame.instances, frame.scene->instances.size())) {
        if (is_outline(instance)) instance.double_sided = false;
      }
    }
    return {};
  }
};

}  // namespace zstrip::detail::outlines
