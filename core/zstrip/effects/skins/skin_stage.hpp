// Checks frames with skins that are moved while they are drawn.
#pragma once

#include "zstrip/effects/stage.hpp"

namespace zstrip::detail::skins {

/// Returns Error::skin (`needed` = index of the mesh) if a Skinning does not have the sizes of its mesh, or if lines,
/// edges or CSG, which read vertices from the mesh, use a skin.
Status check(const Scene& scene);

struct Stage : NoStage {
  static constexpr Effects kEffects = effect::skins;

  template <Effects effects>
  static Status check(const FrameRequest& request) {
    return request.called_for.has(effect::skins) ? skins::check(request.scene) : Status{};
  }
};

}  // namespace zstrip::detail::skins
