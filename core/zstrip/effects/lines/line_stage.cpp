// Prepares the sets of lines of a frame; only renderers with effect::lines link it.
#include "zstrip/effects/lines/lines.hpp"
#include "zstrip/frame/bounds.hpp"
#include "zstrip/frame/frame_inline.hpp"

namespace zstrip {
void detail::extend_by_lines(DistanceRange& reach, const Scene& scene, const Camera& camera) {
  for (const LineSet& lines : scene.lines) {
    extend(reach, distance_range(scene.meshes[lines.mesh], lines.transform, camera), camera);
  }
}

Status Frame::Access::prepare_lines(Frame& frame, const Scene& scene, const Camera& camera) {
  const bool orthographic = camera.projection == Projection::orthographic;
  const std::int32_t centre_x = frame.view_.width >> 1, centre_y = frame.view_.height >> 1;
  const std::span<detail::CompiledLines> all = lines_of(frame, scene);
  for (std::uint32_t i = 0; i < all.size(); ++i) {
    detail::CompiledLines& compiled = all[i];
    const LineSet& lines = scene.lines[i];
    compiled.instance.visible = false;
    if (frame.fit_.near == 0) continue;
    const Instance instance{.mesh = lines.mesh, .material = lines.material, .transform = lines.transform};
    if (!detail::compile_instance(compiled.instance, scene, instance, camera, frame.view_, frame.fit_)) {
      return {.error = Error::lines, .needed = i};
    }
    if (!compiled.instance.visible) continue;
    // Half a width around the box of its vertices.
    const auto border = static_cast<std::int32_t>(lines.width * sample_columns(frame.view_) / 2 + 1);
    const Rect box = detail::bounds_with_border(compiled.instance, border, frame.origin_, frame.view_, orthographic);
    compiled.instance.visible = !box.empty();
    if (box.empty()) continue;
    extend_bounds(frame, box);
    compiled.box = {box.left - centre_x, box.top - centre_y, box.right - centre_x, box.bottom - centre_y};
  }
  return {};
}

}  // namespace zstrip
