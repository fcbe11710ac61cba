// The stages that visibility methods add to a frame: sorting triangles, drawing them in order, leaving out what cannot
// be seen before its vertices are transformed.
#pragma once

#include <algorithm>
#include <cstdint>

#include "zstrip/frame/frame_inline.hpp"
#include "zstrip/visibility/bsp_order.hpp"

namespace zstrip {

/// Whether the options leave out a meshlet of the whole frame: not in the visible set, or its sphere not in the
/// picture.
template <Effects effects>
bool Frame::Access::Methods::is_left_out(Frame& base, std::uint32_t number, std::uint32_t instance,
                                         std::uint32_t meshlet) {
  auto& frame = static_cast<FrameWithMethod&>(base);
  const std::span<const std::uint32_t> visible = frame.options_.potentially_visible;
  if (number / 32 < visible.size() && (visible[number / 32] >> (number % 32) & 1) == 0) return true;
  if (!frame.options_.cull_by_spheres) return false;
  const detail::CompiledInstance& compiled = frame.instances_[instance];
  if constexpr (effects.has(effect::outlines)) {
    if (detail::is_outline(compiled)) return false;  // its vertices leave their spheres
  }
  const Mesh& mesh = frame.scene_->meshes[compiled.mesh];
  if (mesh.meshlets.empty()) return false;
  return detail::sphere_bounds(compiled, mesh, &mesh.meshlets[meshlet], frame.origin_, frame.view_,
                               effects.has(effect::orthographic))
      .box.empty();
}

/// Whether the bounds of the strip's depth hide a meshlet, or an instance where it is null.
template <Effects effects>
bool Frame::Access::Methods::is_hidden(FrameWithMethod& frame, const detail::StripTarget& target,
                                       std::uint32_t instance, const Meshlet* meshlet) {
  const detail::CompiledInstance& compiled = frame.instances_[instance];
  if constexpr (effects.has(effect::outlines)) {
    if (detail::is_outline(compiled)) return false;
  }
  const detail::SphereBounds bounds =
      detail::sphere_bounds(compiled, frame.scene_->meshes[compiled.mesh], meshlet, frame.origin_, frame.view_,
                            effects.has(effect::orthographic));
  const std::int32_t centre_x = frame.view_.width >> 1;
  const std::int32_t centre_y = frame.view_.height >> 1;
  const Rect box{std::max(bounds.box.left - centre_x, target.area.left),
                 std::max(bounds.box.top - centre_y, target.area.top),
                 std::min(bounds.box.right - centre_x, target.area.right),
                 std::min(bounds.box.bottom - centre_y, target.area.bottom)};
  return box.empty() || frame.state_.bounds.hides(box, bounds.nearest, frame.state_.counts);
}

/// Calls draw(number, instance, meshlet) for the meshlets that bounds of depth do not hide: first for those that were
/// seen before, whose depth then hides others. What blends comes last in any case, and where materials have rules of
/// their own for depth everything keeps the scene's order and only those with the usual rule are hidden.
template <Effects effects, class Draw>
void Frame::Access::Methods::draw_seen_first(FrameWithMethod& frame, const detail::StripTarget& target,
                                             const Draw& draw) {
  // The last frame's bits, and behind them those that this one finds; a meshlet may be in several strips.
  const std::span<std::uint32_t> seen = effects.has(method::culling)
                                            ? frame.options_.seen_before.first(frame.options_.seen_before.size() / 2)
                                            : std::span<std::uint32_t>{};
  const auto material_of = [&frame](std::uint32_t instance) -> const Material& {
    return frame.scene_->materials[frame.instances_[instance].material];
  };
  const auto is_drawn_first = [&](std::uint32_t number, std::uint32_t instance) {
    if (frame.state_.keeps_order) return false;
    if (effects.has(effect::blending) && is_blended(*frame.scene_, material_of(instance))) return false;
    return number / 32 < seen.size() && (seen[number / 32] >> (number % 32) & 1) != 0;
  };
  if (!seen.empty()) {
    Geometry::for_each_meshlet<effects>(frame,
                                        [&](std::uint32_t number, std::uint32_t instance, std::uint32_t meshlet) {
                                          if (!is_drawn_first(number, instance)) return;
                                          if (effects.has(effect::statistics)) ++frame.counts_.drawn_first;
                                          draw(number, instance, meshlet);
                                        });
  }
  std::uint32_t asked = UINT32_MAX;  // the instance that `hidden` is of
  bool hidden = false;
  Geometry::for_each_meshlet<effects>(frame, [&](std::uint32_t number, std::uint32_t instance, std::uint32_t index) {
    const Mesh& mesh = frame.scene_->meshes[frame.instances_[instance].mesh];
    const bool drawn = is_drawn_first(number, instance);
    const bool may_be_hidden = !effects.has(effect::depth_state) || !has_depth_state(material_of(instance));
    if (instance != asked && !drawn) {
      asked = instance;
      hidden = may_be_hidden && is_hidden<effects>(frame, target, instance, nullptr);
      if (hidden && effects.has(effect::statistics)) ++frame.counts_.instances;
    }
    const Meshlet* const meshlet = mesh.meshlets.empty() ? nullptr : &mesh.meshlets[index];
    const bool all_hidden = (instance == asked && hidden) || (meshlet != nullptr && may_be_hidden &&
                                                              is_hidden<effects>(frame, target, instance, meshlet));
    if (!drawn) {
      if (!all_hidden) {
        draw(number, instance, index);
      } else if (effects.has(effect::statistics)) {
        ++frame.counts_.meshlets;
      }
    }
    if (all_hidden || number / 32 >= seen.size()) return;
    frame.options_.seen_before[seen.size() + number / 32] |= 1U << (number % 32);
  });
}

/// Finds all front faces that may be in the picture, in the scene's order, with their keys (0 for a tree); with a
/// z-buffer those of what blends are behind all others, in the plain z-buffer's order.
template <Effects effects>
void Frame::Access::Methods::collect_triangles(FrameWithMethod& frame) {
  constexpr bool kOrthographic = effects.has(effect::orthographic);
  std::uint32_t count = 0;
  std::uint32_t retained = 0;
  std::uint16_t batches = 0;
  // Codes begin at 1, in 16.16: what blends has keys below them, that of one instance the same.
  [[maybe_unused]] std::uint32_t blended_key = kMostSortedIndex;
  [[maybe_unused]] std::uint32_t blended_instance = UINT32_MAX;
  Geometry::for_each_meshlet<effects>(frame, [&]([[maybe_unused]] std::uint32_t number, std::uint32_t instance,
                                                 std::uint32_t meshlet) {
    if constexpr (effects.has(method::culling)) {
      if (is_left_out<effects>(frame, number, instance, meshlet)) return;
    }
    const bool binned = effects.has(effect::bins) && frame.mode_ == Mode::binned;
    const detail::CompiledInstance& compiled = frame.instances_[instance];
    const Geometry::MeshletRange range = Geometry::meshlet_range(frame.scene_->meshes[compiled.mesh], meshlet);
    const std::uint32_t cache = binned ? retained : 0;
    const auto batch = Geometry::batch_for<effects>(frame, instance, range.first_vertex, cache);
    const bool all_narrow = Geometry::transform<effects>(frame, batch, range, cache);
    // A vertex outside the depth range counts as on its border.
    [[maybe_unused]] const auto depth = [&](std::uint32_t index) {
      const detail::SnappedVertex& v = batch.vertices[index - range.first_vertex];
      if (v.x != detail::kNotNarrow) return v.depth;
      const std::int32_t nearest = static_cast<std::int32_t>(compiled.w_near);
      const std::int32_t w = std::clamp(Assembler<effects>::distance_of(batch, index), nearest,
                                        nearest + static_cast<std::int32_t>(compiled.w_range));
      const detail::Reciprocal r =
          kOrthographic ? detail::Reciprocal{0, 0} : detail::reciprocal_of(static_cast<std::uint32_t>(w));
      return detail::project_depth<kOrthographic>(compiled, frame.origin_, w, r);
    };
    [[maybe_unused]] bool is_last = false;
    if constexpr (effects.has(effect::blending) && !effects.has(method::painter)) {
      is_last = is_blended(*frame.scene_, frame.scene_->materials[compiled.material]);
      if (is_last && instance != blended_instance) --blended_key, blended_instance = instance;
    }
    bool listed = false;
    detail::Facing<effects>::for_each(
        batch, range.triangles, all_narrow, [&](std::uint32_t index, const auto& covered) {
          const detail::Extent extent = frame.grid_.extent_of(covered.box());
          if (extent.empty()) return true;
          [[maybe_unused]] const Triangle& triangle = range.triangles[index];
          listed = true;
          std::uint32_t key = 0;
          if constexpr (!effects.has(method::bsp)) {
            key = is_last
                      ? blended_key
                      : detail::depth_key(frame.options_.key, depth(triangle.a), depth(triangle.b), depth(triangle.c));
          }
          frame.sorted_[count++] = {key,
                                    static_cast<std::uint16_t>(instance),
                                    static_cast<std::uint16_t>(meshlet),
                                    static_cast<std::uint16_t>(index),
                                    batches,
                                    extent};
          return true;
        });
    if (!listed || !binned) return;
    Geometry::shade<effects>(frame, batch, range, cache);
    if constexpr (effects.has(effect::shadows)) Geometry::shade_in_shadow<effects>(frame, batch, range, cache);
    frame.batches_[batches++] = detail::retained_batch(instance, meshlet, retained, all_narrow);
    retained += range.vertex_count;
  });
  frame.sorted_count_ = count;
}

/// Gives the triangles that were collected the order of a tree, for the scene's only mesh.
template <Effects effects>
Status Frame::Access::Methods::key_by_tree(FrameWithMethod& frame, const Camera& camera) {
  constexpr Status kNotOfThisScene{.error = Error::visibility, .needed = method::bsp.methods};
  const BspTree* const tree = frame.options_.tree;
  const Scene& scene = *frame.scene_;
  if (tree == nullptr || scene.instances.size() != 1) return kNotOfThisScene;
  const Mesh& mesh = scene.meshes[scene.instances[0].mesh];
  detail::SortedTriangle* const end = frame.sorted_ + frame.sorted_count_;
  const auto number_of = [&mesh](const detail::SortedTriangle& t) {
    return (mesh.meshlets.empty() ? 0 : mesh.meshlets[t.meshlet].first_triangle) + t.triangle;
  };
  const auto is_before = [&](const detail::SortedTriangle& t, std::uint32_t number) { return number_of(t) < number; };
  std::uint32_t place = 0;
  const detail::BspEye eye = detail::bsp_eye(mesh, scene.instances[0].transform, camera);
  const bool whole =
      detail::for_each_bsp_run(*tree, eye, mesh.triangles.size(), [&](std::uint32_t first, std::uint32_t count) {
        // They were collected in the mesh's order.
        detail::SortedTriangle* t = std::lower_bound(frame.sorted_, end, first, is_before);
        for (; t != end && number_of(*t) < first + count; ++t) t->key = place++;
        return true;
      });
  return whole ? Status{} : kNotOfThisScene;
}

/// Puts the triangles in the method's order and, if binned, lists them in it.
template <Effects effects>
Status Frame::Access::Methods::order_triangles(FrameWithMethod& frame, const Camera& camera) {
  collect_triangles<effects>(frame);
  if constexpr (effects.has(method::bsp)) {
    if (const Status status = key_by_tree<effects>(frame, camera); !status) {
      frame.scene_ = nullptr;
      return status;
    }
  }
  detail::sort_near_to_far({frame.sorted_, frame.sorted_count_});
  if constexpr (effects.has(method::painter)) std::reverse(frame.sorted_, frame.sorted_ + frame.sorted_count_);
  if constexpr (effects.has(effect::bins)) {
    if (frame.mode_ != Mode::binned) return {};
    for (const detail::SortedTriangle& t : std::span(frame.sorted_, frame.sorted_count_)) {
      if (Geometry::list(frame, t.extent, t.batch, t.triangle)) continue;
      frame.mode_ = Mode::streamed;
      ++frame.bin_overflows_;
      break;
    }
  }
  return {};
}

/// Transforms the vertices of each triangle again: neighbours in the order rarely share any.
template <Effects effects>
void Frame::Access::Methods::draw_sorted(FrameWithMethod& frame, const detail::StripTarget& target,
                                         std::uint16_t strip) {
  const std::int32_t row = strip / frame.grid_.across();
  const std::int32_t column = strip % frame.grid_.across();
  for (const detail::SortedTriangle& sorted : std::span(frame.sorted_, frame.sorted_count_)) {
    if (!frame.grid_.touches(sorted.extent, row, column)) continue;
    const Geometry::MeshletRange range =
        Geometry::meshlet_range(frame.scene_->meshes[frame.instances_[sorted.instance].mesh], sorted.meshlet);
    const auto batch = Geometry::batch_for<effects>(frame, sorted.instance, range.first_vertex, 0);
    const Triangle& triangle = range.triangles[sorted.triangle];
    for (const std::uint32_t index : {triangle.a, triangle.b, triangle.c}) {
      const Geometry::MeshletRange vertex{index, 1, {}};
      const std::uint32_t cache = index - range.first_vertex;
      Geometry::transform<effects>(frame, batch, vertex, cache);
      Geometry::shade<effects>(frame, batch, vertex, cache);
    }
    Materials::with_settings<effects>(frame, target, *batch.instance, [&](const auto& complete) {
      Assembler<effects>::draw_listed(complete, batch, range.triangles, {&sorted.triangle, 1}, false);
    });
  }
}

/// A pass over all triangles that only counts which culling would leave them out, in the order in which they ask.
template <Effects effects>
void Frame::Access::Methods::count_culled(FrameWithMethod& frame) {
  VisibilityStatistics& counts = frame.counts_;
  const std::uint32_t before = frame.statistics_.vertices;
  Geometry::for_each_meshlet<effects>(frame, [&](std::uint32_t number, std::uint32_t instance, std::uint32_t meshlet) {
    const detail::CompiledInstance& compiled = frame.instances_[instance];
    const Geometry::MeshletRange range = Geometry::meshlet_range(frame.scene_->meshes[compiled.mesh], meshlet);
    const auto triangles = static_cast<std::uint32_t>(range.triangles.size());
    if (is_left_out<effects>(frame, number, instance, meshlet)) {
      const std::span<const std::uint32_t> visible = frame.options_.potentially_visible;
      const bool by_set = number / 32 < visible.size() && (visible[number / 32] >> (number % 32) & 1) == 0;
      (by_set ? counts.outside_cells : counts.outside) += triangles;
      return;
    }
    const auto batch = Geometry::batch_for<effects>(frame, instance, range.first_vertex, 0);
    const bool all_narrow = Geometry::transform<effects>(frame, batch, range, 0);
    std::uint32_t facing = 0;
    detail::Facing<effects>::for_each(batch, range.triangles, all_narrow, [&](std::uint32_t, const auto& covered) {
      ++facing;
      if (covered.box().empty() && frame.options_.cull_small) ++counts.small;
      return true;
    });
    if (frame.options_.cull_back_faces) counts.back_faces += triangles - facing;
  });
  frame.statistics_.vertices = before;
}

}  // namespace zstrip
