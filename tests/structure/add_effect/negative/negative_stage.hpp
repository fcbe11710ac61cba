// The negative: bits of a pixel are inverted after everything that draws.
#pragma once

#include "zstrip/effects/negative/effect.hpp"
#include "zstrip/effects/stage.hpp"

namespace zstrip::detail::negative {

struct Stage : NoStage {
  static constexpr Effects kEffects = effect::negative;

  template <Effects effects>
  static Status prepare(FrameState& frame, const FrameRequest& request) {
    if (request.called_for.has(effect::negative)) *effect_block(frame).at<Effect, std::uint32_t>() = 0xFFFF;
    return {};
  }
  template <Effects effects>
  static void resolve(const FrameState& frame, const StripTarget&, StripImage& image) {
    if (!effect_block(frame).has(effect::negative)) return;
    const std::uint32_t inverted = *effect_block(frame).at<Effect, std::uint32_t>();
    const std::int32_t pixels = image.area.width() * image.area.height();
    for (std::int32_t i = 0; i < pixels; ++i) image.pixels[i] = static_cast<std::uint16_t>(image.pixels[i] ^ inverted);
  }
};

}  // namespace zstrip::detail::negative
