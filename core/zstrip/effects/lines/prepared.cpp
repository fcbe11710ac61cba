// Prepares the sets of lines of a frame; only renderers with effect::lines link it.
#include "zstrip/effects/lines/prepared.hpp"

#include "zstrip/state/bounds.hpp"

namespace zstrip::detail::lines {
void extend(DistanceRange& reach, const Scene& scene, const Camera& camera) {
  for (const LineSet& lines : scene.lines) {
    detail::extend(reach, distance_range(scene.meshes[lines.mesh], lines.transform, camera), camera);
  }
}

Status prepare(FrameState& frame, const Scene& scene, const Camera& camera) {
  const bool orthographic = camera.projection == Projection::orthographic;
  const std::int32_t centre_x = frame.view.width >> 1, centre_y = frame.view.height >> 1;
  const std::span<CompiledLines> all = compiled_lines(frame.instances, scene);
  for (std::uint32_t i = 0; i < all.size(); ++i) {
    CompiledLines& compiled = all[i];
    const LineSet& lines = scene.lines[i];
    compiled.instance.visible = false;
    if (frame.fit.near == 0) continue;
    const Instance instance{.mesh = lines.mesh, .material = lines.material, .transform = lines.transform};
    if (!compile_instance(compiled.instance, scene, instance, camera, frame.view, frame.fit)) {
      return {.error = Error::lines, .needed = i};
    }
    if (!compiled.instance.visible) continue;
    // Extends the box of the vertices by half a line width.
    const auto border = static_cast<std::int32_t>(lines.width * sample_columns(frame.view) / 2 + 1);
    const Rect box = bounds_with_border(compiled.instance, border, frame.origin, frame.view, orthographic);
    compiled.instance.visible = !box.empty();
    if (box.empty()) continue;
    extend_bounds(frame, box);
    compiled.box = {box.left - centre_x, box.top - centre_y, box.right - centre_x, box.bottom - centre_y};
  }
  return {};
}

}  // namespace zstrip::detail::lines
