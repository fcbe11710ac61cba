// Renderers of skins that are moved while they are drawn: what a frame must have.
#pragma once

#include "zstrip/effects/stage.hpp"

namespace zstrip::detail::skins {

/// Error::skin (`needed` = index of the mesh) where a Skinning has not the sizes of its mesh, and for lines, edges and
/// CSG, which read vertices where they are.
Status check(const Scene& scene);

struct Stage : NoStage {
  static constexpr Effects kEffects = effect::skins;

  template <Effects effects>
  static Status check(const FrameRequest& request) {
    return request.called_for.has(effect::skins) ? skins::check(request.scene) : Status{};
  }
};

}  // namespace zstrip::detail::skins
