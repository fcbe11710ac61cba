// Rotates the instances of billboards towards the viewer, before a frame is prepared.
#pragma once

#include "zstrip/effects/stage.hpp"

namespace zstrip::detail::billboards {

/// Rotates the scene's billboards towards the camera. Its instances then lie in the effects' part of the arena.
Status turn(const FrameState& frame, Scene& scene, const Camera& camera);

struct Stage : NoStage {
  static constexpr Effects kEffects = effect::billboards;
  static constexpr bool kChangesScene = true;

  template <Effects effects>
  static Status change_scene(const FrameState& frame, Scene& drawn, const FrameRequest& request, const Camera& facing) {
    return request.called_for.has(effect::billboards) ? turn(frame, drawn, facing) : Status{};
  }
};

}  // namespace zstrip::detail::billboards
