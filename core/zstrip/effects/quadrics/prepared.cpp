// Prepares the quadrics of a frame; only renderers with effect::quadrics link it.
#include "zstrip/effects/quadrics/prepared.hpp"

namespace zstrip::detail::quadrics {

Status prepare(FrameState& frame, const Scene& scene, const Camera& camera) {
  CompiledQuadric* const all = compiled(frame, scene);
  const std::int32_t centre_x = frame.view.width >> 1, centre_y = frame.view.height >> 1;
  for (std::uint32_t i = 0; i < scene.quadrics.size(); ++i) {
    all[i].visible = false;
    if (frame.fit.near == 0) continue;
    const Status status =
        compile_quadric(all[i], scene, scene.quadrics[i], camera, frame.view, frame.fit, frame.origin);
    if (!status) return {.error = status.error, .needed = i};
    if (!all[i].visible) continue;
    const Rect& box = all[i].box;
    extend_bounds(frame, {box.left + centre_x, box.top + centre_y, box.right + centre_x, box.bottom + centre_y});
  }
  return {};
}

}  // namespace zstrip::detail::quadrics
