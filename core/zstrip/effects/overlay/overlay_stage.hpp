// The hooks of effect::overlay in the stages of a frame: draw over a strip's finished pixels.
#pragma once

#include "zstrip/effects/stage.hpp"
#include "zstrip/overlay.hpp"
#include "zstrip/scene/valid_overlay.hpp"

namespace zstrip::detail::overlay {

struct Stage : NoStage {
  static constexpr Effects kEffects = effect::overlay;

  template <Effects effects>
  static Status check(const FrameRequest& request) {
    const Overlay* const overlay = request.scene.overlay;
    return overlay != nullptr ? validate_items(*overlay) : Status{};
  }
  /// Refuses draw_over: its pixels may not be finished.
  template <Effects effects>
  static Status check_over(const FrameState& frame) {
    return frame.scene->overlay != nullptr ? Status{.error = Error::overlay} : Status{};
  }
  template <Effects effects>
  static void resolve(const FrameState& frame, const StripTarget&, StripImage& image) {
    if (frame.scene->overlay != nullptr) draw_overlay(*frame.scene->overlay, image.area, image.pixels);
  }
};

}  // namespace zstrip::detail::overlay
