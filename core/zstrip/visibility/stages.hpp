// The stages that visibility methods add to a frame: they sort triangles, draw them in order, and skip invisible
// meshlets before their vertices are transformed.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip/stages/raster_stage.hpp"
#include "zstrip/state/bounds.hpp"
#include "zstrip/visibility/bsp_order.hpp"

namespace zstrip::detail {

[[gnu::noinline]] inline Status MethodStage::begin_frame(MethodFrameState& frame, Effects effects, Effects called_for,
                                                         const SceneCounts& counts, std::span<std::byte> arena) {
  const Plan& plan = frame.plan;
  const std::uint64_t needed = visibility_bytes(effects, counts.triangles, plan.strip_columns, plan.strip_rows);
  if (plan.visibility_bytes < needed) {
    return {.error = Error::arena_too_small,
            .purpose = visibility_purpose(effects),
            .needed = static_cast<std::uint32_t>(needed),
            .available = plan.visibility_bytes};
  }
  if (sorts_triangles(effects) && (counts.longest_meshlet > kMaxSortedIndex || counts.meshlets > kMaxSortedIndex ||
                                   counts.instances > kMaxSortedIndex)) {
    return {.error = Error::unplannable};
  }
  std::byte* const memory = arena.data() + (plan.bytes() - plan.visibility_bytes);
  const std::uint32_t sorted = sorts_triangles(effects) ? counts.triangles * kSortedTriangleBytes : 0;
  frame.sorted = reinterpret_cast<SortedTriangle*>(memory);
  frame.sorted_count = 0;
  frame.depth_bounds = memory + sorted;
  frame.counts = {};
  frame.state = {};
  frame.state.counts = effects.has(effect::statistics) ? &frame.counts : nullptr;
  frame.state.iterations = std::min(frame.options.iterations, kMaxIterations);
  frame.state.cull_small = frame.options.cull_small;
  if (effects.has(effect::depth_state)) frame.state.keeps_order = called_for.has(effect::depth_state);
  if (effects.has(method::culling) && !frame.options.cull_back_faces) {
    for (std::uint32_t i = 0; i < counts.instances; ++i) frame.instances[i].double_sided = true;
  }
  if (effects.has(method::culling)) {
    const std::span<std::uint32_t> seen = frame.options.seen_before;
    const auto found = seen.begin() + static_cast<std::ptrdiff_t>(seen.size() / 2);
    std::copy(found, found + (found - seen.begin()), seen.begin());
    std::fill(found, seen.end(), 0U);
  }
  return {};
}

[[gnu::noinline]] inline void MethodStage::begin_strip(MethodFrameState& frame, Effects effects, StripTarget& target) {
  // Without depth memory the pixel's address identifies it; it is not used to read or write.
  if (effects.has(method::painter)) target.depth = target.colour;
  const auto cells = static_cast<std::uint32_t>(target.area.width() * target.area.height());
  frame.state.first_cell = target.depth;
  frame.state.overdraw = effects.has(effect::statistics) ? frame.options.overdraw : nullptr;
  if (frame.state.overdraw != nullptr) __builtin_memset(frame.state.overdraw, 0, cells);
  if (effects.any(method::bounded) && cells != 0)
    frame.state.bounds.begin(frame.depth_bounds, target.area, target.depth);
}

/// True if the options exclude a meshlet from the whole frame: it is not in the visible set, or its sphere is outside
/// the picture.
template <Effects effects>
bool MethodStage::is_left_out(FrameState& base, std::uint32_t number, std::uint32_t instance, std::uint32_t meshlet) {
  auto& frame = static_cast<MethodFrameState&>(base);
  const std::span<const std::uint32_t> visible = frame.options.potentially_visible;
  if (number / 32 < visible.size() && (visible[number / 32] >> (number % 32) & 1) == 0) return true;
  if (!frame.options.cull_by_spheres) return false;
  const CompiledInstance& compiled = frame.instances[instance];
  if constexpr (effects.has(effect::outlines)) {
    if (is_outline(compiled)) return false;  // the vertices of a hull lie outside the spheres
  }
  const Mesh& mesh = frame.scene->meshes[compiled.mesh];
  if (mesh.meshlets.empty()) return false;
  return sphere_bounds(compiled, mesh, &mesh.meshlets[meshlet], frame.origin, frame.view,
                       effects.has(effect::orthographic))
      .box.empty();
}

/// True if the strip's bounds of depth hide a meshlet, or the whole instance if `meshlet` is null.
template <Effects effects>
bool MethodStage::is_hidden(MethodFrameState& frame, const StripTarget& target, std::uint32_t instance,
                            const Meshlet* meshlet) {
  const CompiledInstance& compiled = frame.instances[instance];
  if constexpr (effects.has(effect::outlines)) {
    if (is_outline(compiled)) return false;
  }
  const SphereBounds bounds = sphere_bounds(compiled, frame.scene->meshes[compiled.mesh], meshlet, frame.origin,
                                            frame.view, effects.has(effect::orthographic));
  const std::int32_t centre_x = frame.view.width >> 1;
  const std::int32_t centre_y = frame.view.height >> 1;
  const Rect box = Rect{bounds.box.left - centre_x, bounds.box.top - centre_y, bounds.box.right - centre_x,
                        bounds.box.bottom - centre_y}
                       .cut_to(target.area);
  return box.empty() || frame.state.bounds.hides(box, bounds.nearest, frame.state.counts);
}

/// Calls draw(number, instance, meshlet) for the meshlets that bounds of depth do not hide. Meshlets that were visible
/// before come first, so that their depth hides others. Blended meshlets always come last. If materials have their own
/// depth rules, all meshlets keep the scene's order, and only those with the default rule can be hidden.
template <Effects effects, class Draw>
void MethodStage::draw_seen_first(MethodFrameState& frame, const StripTarget& target, const Draw& draw) {
  // The last frame's bits, followed by those that this frame sets; a meshlet may be in several strips.
  const std::span<std::uint32_t> seen = effects.has(method::culling)
                                            ? frame.options.seen_before.first(frame.options.seen_before.size() / 2)
                                            : std::span<std::uint32_t>{};
  const auto material_of = [&frame](std::uint32_t instance) -> const Material& {
    return frame.scene->materials[frame.instances[instance].material];
  };
  const auto is_drawn_first = [&](std::uint32_t number, std::uint32_t instance) {
    if (frame.state.keeps_order) return false;
    if (effects.has(effect::blending) && is_blended(*frame.scene, material_of(instance))) return false;
    return number / 32 < seen.size() && (seen[number / 32] >> (number % 32) & 1) != 0;
  };
  if (!seen.empty()) {
    GeometryStage::for_each_meshlet<effects>(frame,
                                             [&](std::uint32_t number, std::uint32_t instance, std::uint32_t meshlet) {
                                               if (!is_drawn_first(number, instance)) return;
                                               if (effects.has(effect::statistics)) ++frame.counts.drawn_first;
                                               draw(number, instance, meshlet);
                                             });
  }
  std::uint32_t tested = UINT32_MAX;  // the instance to which `hidden` applies
  bool hidden = false;
  GeometryStage::for_each_meshlet<effects>(
      frame, [&](std::uint32_t number, std::uint32_t instance, std::uint32_t index) {
        const Mesh& mesh = frame.scene->meshes[frame.instances[instance].mesh];
        const bool drawn = is_drawn_first(number, instance);
        const bool may_be_hidden = !effects.has(effect::depth_state) || !has_depth_state(material_of(instance));
        if (instance != tested && !drawn) {
          tested = instance;
          hidden = may_be_hidden && is_hidden<effects>(frame, target, instance, nullptr);
          if (hidden && effects.has(effect::statistics)) ++frame.counts.instances;
        }
        const Meshlet* const meshlet = mesh.meshlets.empty() ? nullptr : &mesh.meshlets[index];
        const bool all_hidden =
            (instance == tested && hidden) ||
            (meshlet != nullptr && may_be_hidden && is_hidden<effects>(frame, target, instance, meshlet));
        if (!drawn) {
          if (!all_hidden) {
            draw(number, instance, index);
          } else if (effects.has(effect::statistics)) {
            ++frame.counts.meshlets;
          }
        }
        if (all_hidden || number / 32 >= seen.size()) return;
        frame.options.seen_before[seen.size() + number / 32] |= 1U << (number % 32);
      });
}

/// Collects all front faces that may be in the picture, in the scene's order, with their keys (0 for a tree). With a
/// z-buffer, blended faces come after all others, in the order of the plain z-buffer.
template <Effects effects>
void MethodStage::collect_triangles(MethodFrameState& frame) {
  constexpr bool kOrthographic = effects.has(effect::orthographic);
  std::uint32_t count = 0;
  std::uint32_t retained = 0;
  std::uint16_t batches = 0;
  // Codes begin at 1, in 16.16: blended triangles have smaller keys, which are equal within an instance.
  [[maybe_unused]] std::uint32_t blended_key = kMaxSortedIndex;
  [[maybe_unused]] std::uint32_t blended_instance = UINT32_MAX;
  GeometryStage::for_each_meshlet<effects>(
      frame, [&]([[maybe_unused]] std::uint32_t number, std::uint32_t instance, std::uint32_t meshlet) {
        if constexpr (effects.has(method::culling)) {
          if (is_left_out<effects>(frame, number, instance, meshlet)) return;
        }
        const bool binned = effects.has(effect::bins) && frame.mode == Mode::binned;
        const CompiledInstance& compiled = frame.instances[instance];
        const MeshletRange range = meshlet_range(frame.scene->meshes[compiled.mesh], meshlet);
        const std::uint32_t cache = binned ? retained : 0;
        const auto batch = GeometryStage::batch_for<effects>(frame, instance, range.first_vertex, cache);
        const bool all_narrow = GeometryStage::transform<effects>(frame, batch, range, cache);
        // A vertex outside the depth range gets the depth of the range's end.
        [[maybe_unused]] const auto depth = [&](std::uint32_t index) {
          const SnappedVertex& v = batch.vertices[index - range.first_vertex];
          if (v.x != kNotNarrow) return v.depth;
          const std::int32_t nearest = static_cast<std::int32_t>(compiled.w_near);
          const std::int32_t w = std::clamp(ClipperFor<effects>::distance_of(batch, index), nearest,
                                            nearest + static_cast<std::int32_t>(compiled.w_range));
          const Reciprocal r = kOrthographic ? Reciprocal{0, 0} : reciprocal_of(static_cast<std::uint32_t>(w));
          return project_depth<kOrthographic>(compiled, frame.origin, w, r);
        };
        [[maybe_unused]] bool is_last = false;
        if constexpr (effects.has(effect::blending) && !effects.has(method::painter)) {
          is_last = is_blended(*frame.scene, frame.scene->materials[compiled.material]);
          if (is_last && instance != blended_instance) --blended_key, blended_instance = instance;
        }
        bool listed = false;
        Facing<effects>::for_each(batch, range.triangles, all_narrow, [&](std::uint32_t index, const auto& covered) {
          const Extent extent = frame.grid.extent_of(covered.box());
          if (extent.empty()) return true;
          [[maybe_unused]] const Triangle& triangle = range.triangles[index];
          listed = true;
          std::uint32_t key = 0;
          if constexpr (!effects.has(method::bsp)) {
            key = is_last ? blended_key
                          : depth_key(frame.options.key, depth(triangle.a), depth(triangle.b), depth(triangle.c));
          }
          frame.sorted[count++] = {key,
                                   static_cast<std::uint16_t>(instance),
                                   static_cast<std::uint16_t>(meshlet),
                                   static_cast<std::uint16_t>(index),
                                   batches,
                                   extent};
          return true;
        });
        if (!listed || !binned) return;
        GeometryStage::shade<effects>(frame, batch, range, cache);
        GeometryStage::retain_shadow<effects>(frame, batch, range, cache);
        frame.batches[batches++] = retained_batch(instance, meshlet, retained, all_narrow);
        retained += range.vertex_count;
      });
  frame.sorted_count = count;
}

/// Puts the collected triangles in the order of a tree, for the scene's only mesh.
template <Effects effects>
Status MethodStage::key_by_tree(MethodFrameState& frame, const Camera& camera) {
  constexpr Status kNotOfThisScene{.error = Error::visibility, .needed = method::bsp.methods};
  const BspTree* const tree = frame.options.tree;
  const Scene& scene = *frame.scene;
  if (tree == nullptr || scene.instances.size() != 1) return kNotOfThisScene;
  const Mesh& mesh = scene.meshes[scene.instances[0].mesh];
  SortedTriangle* const end = frame.sorted + frame.sorted_count;
  const auto number_of = [&mesh](const SortedTriangle& t) {
    return (mesh.meshlets.empty() ? 0 : mesh.meshlets[t.meshlet].first_triangle) + t.triangle;
  };
  const auto is_before = [&](const SortedTriangle& t, std::uint32_t number) { return number_of(t) < number; };
  std::uint32_t place = 0;
  const BspEye eye = bsp_eye(mesh, scene.instances[0].transform, camera);
  const bool whole = for_each_bsp_run(*tree, eye, mesh.triangles.size(), [&](std::uint32_t first, std::uint32_t count) {
    // The triangles were collected in the mesh's order.
    SortedTriangle* t = std::lower_bound(frame.sorted, end, first, is_before);
    for (; t != end && number_of(*t) < first + count; ++t) t->key = place++;
    return true;
  });
  return whole ? Status{} : kNotOfThisScene;
}

/// Sorts the triangles in the method's order and, if binned, lists them in that order.
template <Effects effects>
Status MethodStage::order_triangles(MethodFrameState& frame, const Camera& camera) {
  collect_triangles<effects>(frame);
  if constexpr (effects.has(method::bsp)) {
    if (const Status status = key_by_tree<effects>(frame, camera); !status) {
      frame.scene = nullptr;
      return status;
    }
  }
  sort_near_to_far({frame.sorted, frame.sorted_count});
  if constexpr (effects.has(method::painter)) std::reverse(frame.sorted, frame.sorted + frame.sorted_count);
  if constexpr (effects.has(effect::bins)) {
    if (frame.mode != Mode::binned) return {};
    for (const SortedTriangle& t : std::span(frame.sorted, frame.sorted_count)) {
      if (GeometryStage::list(frame, t.extent, t.batch, t.triangle)) continue;
      frame.mode = Mode::streamed;
      ++frame.bin_overflows;
      break;
    }
  }
  return {};
}

/// Transforms the vertices of each triangle again, because neighbours in the order rarely share any.
template <Effects effects>
void MethodStage::draw_sorted(MethodFrameState& frame, const StripTarget& target, std::uint16_t strip) {
  const StripGrid::Place place = frame.grid.place_of(strip);
  for (const SortedTriangle& sorted : std::span(frame.sorted, frame.sorted_count)) {
    if (!frame.grid.touches(sorted.extent, place)) continue;
    const MeshletRange range =
        meshlet_range(frame.scene->meshes[frame.instances[sorted.instance].mesh], sorted.meshlet);
    const auto batch = GeometryStage::batch_for<effects>(frame, sorted.instance, range.first_vertex, 0);
    const Triangle& triangle = range.triangles[sorted.triangle];
    bool all_narrow = kHasSmallRunsOfOne;
    for (const std::uint32_t index : {triangle.a, triangle.b, triangle.c}) {
      const MeshletRange vertex{index, 1, {}};
      const std::uint32_t cache = index - range.first_vertex;
      if (!GeometryStage::transform<effects>(frame, batch, vertex, cache)) all_narrow = false;
      GeometryStage::shade<effects>(frame, batch, vertex, cache);
    }
    AssemblerFor<effects>::draw(Materials::instance_target<effects>(frame, target, *batch.instance), batch,
                                {&triangle, 1}, all_narrow);
  }
}

/// Visits all triangles only to count those that culling excludes, in the order of the tests.
template <Effects effects>
void MethodStage::count_culled(MethodFrameState& frame) {
  VisibilityStatistics& counts = frame.counts;
  const std::uint32_t before = frame.statistics.vertices;
  GeometryStage::for_each_meshlet<effects>(
      frame, [&](std::uint32_t number, std::uint32_t instance, std::uint32_t meshlet) {
        const CompiledInstance& compiled = frame.instances[instance];
        const MeshletRange range = meshlet_range(frame.scene->meshes[compiled.mesh], meshlet);
        const auto triangles = static_cast<std::uint32_t>(range.triangles.size());
        if (is_left_out<effects>(frame, number, instance, meshlet)) {
          const std::span<const std::uint32_t> visible = frame.options.potentially_visible;
          const bool by_set = number / 32 < visible.size() && (visible[number / 32] >> (number % 32) & 1) == 0;
          (by_set ? counts.outside_cells : counts.outside) += triangles;
          return;
        }
        const auto batch = GeometryStage::batch_for<effects>(frame, instance, range.first_vertex, 0);
        const bool all_narrow = GeometryStage::transform<effects>(frame, batch, range, 0);
        std::uint32_t facing = 0;
        Facing<effects>::for_each(batch, range.triangles, all_narrow, [&](std::uint32_t, const auto& covered) {
          ++facing;
          if (covered.box().empty() && frame.options.cull_small) ++counts.small;
          return true;
        });
        if (frame.options.cull_back_faces) counts.back_faces += triangles - facing;
      });
  frame.statistics.vertices = before;
}

}  // namespace zstrip::detail
