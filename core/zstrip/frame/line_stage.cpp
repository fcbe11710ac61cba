// Prepares the sets of lines of a frame; only renderers with effect::lines link it.
#include <algorithm>

#include "zstrip/frame/bounds.hpp"
#include "zstrip/frame/frame_inline.hpp"
#include "zstrip/geometry/lines.hpp"

namespace zstrip {
namespace {

/// Picture pixels that the set can cover: those of its vertices' box, and half a width around them.
Rect box_of(const detail::CompiledInstance& instance, std::int32_t width, const detail::RasterOrigin& origin,
            const View& view, bool orthographic) {
  // In a picture with a border, so that what lies beside this one and reaches into it is not lost. Its size keeps
  // the parity of this one's.
  const std::int32_t border = width / 2 + 1;
  View wider = view;
  wider.width = static_cast<std::uint16_t>(view.width + 2 * border);
  wider.height = static_cast<std::uint16_t>(view.height + 2 * border);
  const Rect box = detail::bounds_of(instance, origin, wider, orthographic);
  if (box.empty()) return {};
  const Rect cut{std::max<std::int32_t>(box.left - 2 * border, 0), std::max<std::int32_t>(box.top - 2 * border, 0),
                 std::min<std::int32_t>(box.right, view.width), std::min<std::int32_t>(box.bottom, view.height)};
  return cut.empty() ? Rect{} : cut;
}

}  // namespace

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
    const auto width = static_cast<std::int32_t>(lines.width * sample_columns(frame.view_));
    const Rect box = box_of(compiled.instance, width, frame.origin_, frame.view_, orthographic);
    compiled.instance.visible = !box.empty();
    if (box.empty()) continue;
    extend_bounds(frame, box);
    compiled.box = {box.left - centre_x, box.top - centre_y, box.right - centre_x, box.bottom - centre_y};
  }
  return {};
}

}  // namespace zstrip
