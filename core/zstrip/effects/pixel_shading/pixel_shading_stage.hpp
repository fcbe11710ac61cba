// Prepares instances that are lit at their pixels.
#pragma once

#include "zstrip/effects/stage.hpp"

namespace zstrip::detail::pixel_shading {

/// Call it before the strips: the instances' vertices keep their own colours, without light.
void prepare(FrameState& frame);

struct Stage : NoStage {
  static constexpr Effects kEffects = effect::pixel_shading;

  template <Effects effects>
  static Status prepare(FrameState& frame, const FrameRequest&) {
    pixel_shading::prepare(frame);
    return {};
  }
};

}  // namespace zstrip::detail::pixel_shading
