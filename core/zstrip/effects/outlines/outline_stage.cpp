// Prepares the outlines of a frame; only renderers with effect::outlines link it.
#include "zstrip/effects/outlines/outline_stage.hpp"

#include <new>

#include "zstrip/state/bounds.hpp"

namespace zstrip::detail::outlines {
namespace {

template <class Visit>
void for_each_hull(const OutlinedScene& outlined, const Visit& visit) {
  const Scene& scene = outlined.scene;
  const Scene with_outlines{
      .meshes = {}, .materials = {}, .textures = {}, .instances = {}, .lights = {}, .outlines = outlined.outlines()};
  std::uint32_t hull = outlined.instances;
  for (std::uint32_t i = 0; i < outlined.instances; ++i) {
    const Outline* const outline = outline_of(with_outlines, scene.meshes[scene.instances[i].mesh]);
    if (outline != nullptr) visit(hull++, *outline);
  }
}

}  // namespace

void extend(DistanceRange& reach, const OutlinedScene& outlined, const Camera& camera, const View& view) {
  for_each_hull(outlined, [&](std::uint32_t hull, const Outline& outline) {
    const Instance& instance = outlined.scene.instances[hull];
    const DistanceRange range = distance_range(outlined.scene.meshes[instance.mesh], instance.transform, camera);
    detail::extend(reach, with_outline(range, outline.width, camera, view), camera);
  });
}

void add_hulls(const FrameState& frame, Scene& scene) {
  const std::span<Instance> drawn{effect_block(frame).at<changed_instances::Memory, Instance>(),
                                  effect_block(frame).instances()};
  // The instances are already here if billboards were rotated.
  auto next = static_cast<std::uint32_t>(scene.instances.size());
  for (std::uint32_t i = 0; i < next; ++i) drawn[i] = scene.instances[i];
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
    const Outline* const outline = outline_of(scene, scene.meshes[drawn[i].mesh]);
    if (outline == nullptr) continue;
    drawn[next] = drawn[i];
    drawn[next++].mesh = hull_of(*outline, drawn[i]);
  }
  auto* const outlined = ::new (outlined_of(frame)) OutlinedScene{
      scene, static_cast<std::uint32_t>(scene.outlines.size()), static_cast<std::uint32_t>(scene.instances.size())};
  outlined->scene.instances = drawn;
  outlined->scene.outlines = scene.outlines.first(0);
  scene = outlined->scene;
}

void make_outlines(FrameState& frame, const Camera& camera) {
  const bool orthographic = camera.projection == Projection::orthographic;
  const OutlinedScene& outlined = *outlined_of(frame);
  for_each_hull(outlined, [&](std::uint32_t index, const Outline& outline) {
    CompiledInstance& hull = frame.instances[index];
    if (frame.fit.near == 0 || hull.w_range == 0) return;  // outside the depth range
    make_outline(hull, outline, outlined.scene.instances[index].transform, camera, frame.view, frame.fit);
    // The border is wider than the outline, because normals may be longer than one.
    const std::int32_t border = hull.lights[3].x / 8 + 1;
    const Rect box = bounds_with_border(hull, border, frame.origin, frame.view, orthographic);
    hull.visible = !box.empty();
    if (hull.visible) extend_bounds(frame, box);
  });
}

}  // namespace zstrip::detail::outlines
