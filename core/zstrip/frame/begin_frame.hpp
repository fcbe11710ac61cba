// begin_frame of renderers and pipelines: also begins frames with several samples a pixel, whose strips are drawn in
// a greater picture.
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

}  // namespace zstrip::detail
