// Prepares the fog of a frame: its curve over depth codes, and a background that meets it without a seam.
#pragma once

#include "zstrip/effects/dithering/dither.hpp"
#include "zstrip/effects/fog/curve_of.hpp"
#include "zstrip/effects/stage.hpp"

namespace zstrip::detail::fog {

struct Stage : NoStage {
  static constexpr Effects kEffects = effect::fog;

  template <Effects effects>
  static Status prepare(FrameState& frame, const FrameRequest&) {
    if (frame.scene->fog != nullptr && frame.fit.near != 0) {
      *curve_of(frame) = fog_curve(*frame.scene->fog,
                                   distance_scale(frame.fit, effects.has(effect::orthographic), depth_span(effects)));
    }
    return {};
  }
  /// Dithered fog ends in the background's colour; there is no seam only if the background is dithered, too.
  template <Effects effects>
  static void draw_background(const FrameState& frame, const Rect& area, std::uint16_t* pixels) {
    if constexpr (effects.has(effect::dithered_colours)) {
      if (frame.scene->fog != nullptr && dithers_colours(frame.view)) {
        fill_dithered(area, frame.scene->background, pixels);
      }
    }
  }
};

}  // namespace zstrip::detail::fog
