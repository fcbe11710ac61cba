// Prepares the quadrics of a frame; only renderers with effect::quadrics link it.
#include "zstrip/effects/quadrics/quadric.hpp"
#include "zstrip/frame/frame_inline.hpp"

namespace zstrip {

Status Frame::Access::prepare_quadrics(Frame& frame, const Scene& scene, const Camera& camera) {
  detail::CompiledQuadric* const compiled = quadrics_of(frame, scene);
  const std::int32_t centre_x = frame.view_.width >> 1, centre_y = frame.view_.height >> 1;
  for (std::uint32_t i = 0; i < scene.quadrics.size(); ++i) {
    compiled[i].visible = false;
    if (frame.fit_.near == 0) continue;
    const Status status =
        detail::compile_quadric(compiled[i], scene, scene.quadrics[i], camera, frame.view_, frame.fit_, frame.origin_);
    if (!status) return {.error = status.error, .needed = i};
    if (!compiled[i].visible) continue;
    const Rect& box = compiled[i].box;
    extend_bounds(frame, {box.left + centre_x, box.top + centre_y, box.right + centre_x, box.bottom + centre_y});
  }
  return {};
}

}  // namespace zstrip
