// Dithers pictures in narrow formats just before they are converted.
#pragma once

#include "zstrip/effects/dithering/dither.hpp"
#include "zstrip/effects/stage.hpp"

namespace zstrip::detail::dithering {

struct Stage : NoStage {
  static constexpr Effects kEffects = effect::dithered_format;

  template <Effects effects>
  static void resolve(const FrameState& frame, const StripTarget&, StripImage& image) {
    if (frame.view.dither) dither_pixels(frame.view.format, image.area, image.pixels);
  }
};

}  // namespace zstrip::detail::dithering
