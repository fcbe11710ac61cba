// The functions through which renderers and pipelines call the stages.
#pragma once

#include <span>

#include "zstrip/frame/frame_order.hpp"

namespace zstrip::detail {

template <Effects effects>
Status begin_frame(FrameState& frame, const Scene& scene, const Camera& camera, const View& view, const Plan& plan,
                   std::span<std::byte> arena) {
  if constexpr (effects.has(effect::supersampled)) {
    if (view.samples != 1) {
      abandon(frame);
      return samples::begin_frame<effects>(frame, {scene, camera, view, plan, count(scene), effects_of(scene, camera)},
                                           arena);
    }
  }
  return begin_whole_frame<effects>(frame, scene, camera, view, plan, arena);
}
template <Effects effects>
Status draw_strip(FrameState& frame, std::uint16_t strip, std::span<std::byte> pixels) {
  return draw_whole_strip<effects>(frame, strip, pixels);
}
template <Effects effects>
Status draw_over(FrameState& frame, const Rect& area, std::span<std::uint16_t> pixels, std::span<std::uint16_t> depth) {
  return draw_whole_over<effects>(frame, area, pixels, depth);
}

}  // namespace zstrip::detail
