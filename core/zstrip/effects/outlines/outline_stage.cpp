// Prepares the outlines of a frame; only renderers with effect::outlines link it.
#include "zstrip/effects/outlines/outline_stage.hpp"

#include <new>

#include "zstrip/frame/bounds.hpp"
#include "zstrip/frame/frame_inline.hpp"

namespace zstrip {
namespace {

/// Calls visit(index of the hull's instance, outline) for each of them, in their order.
template <class Visit>
void for_each_hull(const detail::OutlinedScene& outlined, const Visit& visit) {
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

void detail::extend_by_outlines(DistanceRange& reach, const OutlinedScene& outlined, const Camera& camera,
                                const View& view) {
  for_each_hull(outlined, [&](std::uint32_t hull, const Outline& outline) {
    const Instance& instance = outlined.scene.instances[hull];
    const DistanceRange range = distance_range(outlined.scene.meshes[instance.mesh], instance.transform, camera);
    extend(reach, with_outline(range, outline.width, camera, view), camera);
  });
}

void Frame::Access::add_hulls(const Frame& frame, Scene& scene, Effects called_for) {
  const SceneCounts counts = count(scene);
  const detail::EffectBlock block{reinterpret_cast<std::byte*>(frame.batches_) + frame.plan_.bin_bytes,
                                  frame.plan_.effect_bytes, counts.instances};
  block.lay_out(called_for);
  const std::span<Instance> drawn = block.turned();
  // Turned billboards lie where they would without hulls, which is not behind this place: the last one first.
  auto next = static_cast<std::uint32_t>(scene.instances.size());
  for (std::uint32_t i = next; i-- > 0;) drawn[i] = scene.instances[i];
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
    const Outline* const outline = outline_of(scene, scene.meshes[drawn[i].mesh]);
    if (outline == nullptr) continue;
    drawn[next] = drawn[i];
    drawn[next++].mesh = hull_of(*outline, drawn[i]);
  }
  auto* const outlined = ::new (&block.outlined()) detail::OutlinedScene{
      scene, static_cast<std::uint32_t>(scene.outlines.size()), static_cast<std::uint32_t>(scene.instances.size())};
  outlined->scene.instances = drawn;
  outlined->scene.outlines = scene.outlines.first(0);
  scene = outlined->scene;
}

void Frame::Access::prepare_outlines(Frame& frame, const Scene& scene, const Camera& camera) {
  const bool orthographic = camera.projection == Projection::orthographic;
  const detail::OutlinedScene& outlined = effect_block(frame, scene).outlined();
  for_each_hull(outlined, [&](std::uint32_t index, const Outline& outline) {
    detail::CompiledInstance& hull = frame.instances_[index];
    if (frame.fit_.near == 0 || hull.w_range == 0) return;  // not in the depth range
    detail::make_outline(hull, outline, outlined.scene.instances[index].transform, camera, frame.view_, frame.fit_);
    // Normals may be longer than one.
    const std::int32_t border = hull.lights[3].x / 8 + 1;
    const Rect box = detail::bounds_with_border(hull, border, frame.origin_, frame.view_, orthographic);
    hull.visible = !box.empty();
    if (hull.visible) extend_bounds(frame, box);
  });
}

}  // namespace zstrip
