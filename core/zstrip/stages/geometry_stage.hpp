// The geometry stage: transforms and lights meshlets in drawing order, and assigns them to strips.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "zstrip/effects/blending/draw_order.hpp"
#include "zstrip/effects/edges/apron.hpp"
#include "zstrip/effects/environment/reflect.hpp"
#include "zstrip/effects/local_light/shade.hpp"
#include "zstrip/effects/outlines/outline.hpp"
#include "zstrip/effects/shadows/retained_shadow.hpp"
#include "zstrip/effects/skins/move_meshlet.hpp"
#include "zstrip/geometry/meshlet_range.hpp"
#include "zstrip/geometry/shade_vertices.hpp"
#include "zstrip/kernels/list_faces.hpp"
#include "zstrip/kernels/transform.hpp"
#include "zstrip/raster/facing.hpp"
#include "zstrip/stages/materials.hpp"
#include "zstrip/stages/method_stage.hpp"
#include "zstrip/visibility/traits.hpp"

namespace zstrip::detail {

struct GeometryStage {
  /// Calls visit(number, instance index, meshlet index) in drawing order for each visible meshlet. Numbers also count
  /// the meshlets of invisible instances.
  template <Effects effects, class Visit>
  static void for_each_meshlet(const FrameState& frame, const Visit& visit) {
    std::uint32_t number = 0;
    for (std::uint32_t place = 0; place < frame.scene->instances.size(); ++place) {
      std::uint32_t i = place;
      if constexpr (effects.has(effect::blending)) {
        i = blending::instance_at(frame, place);
      }
      const Mesh& mesh = frame.scene->meshes[frame.scene->instances[i].mesh];
      const std::uint32_t meshlets = meshlet_count(mesh);
      if (frame.instances[i].visible) {
        for (std::uint32_t m = 0; m < meshlets; ++m) visit(number + m, i, m);
      }
      number += meshlets;
    }
  }

  /// Returns the batch of a meshlet whose vertices begin at frame.vertices[cache].
  template <Effects effects>
  static Batch batch_of(const FrameState& frame, std::uint32_t instance, std::uint32_t first_vertex,
                        std::uint32_t cache) {
    const CompiledInstance& compiled = frame.instances[instance];
    const Mesh& mesh = frame.scene->meshes[compiled.mesh];
    const bool has_colours = compiled.lit || compiled.coloured;
    const Colour* colours = has_colours ? frame.colours + cache : nullptr;
    if (has_colours_of_mesh<effects>(compiled)) colours = mesh.colours.data() + first_vertex;
    return {&compiled,    &mesh_of<effects>(mesh, first_vertex), frame.vertices + cache, colours, first_vertex,
            frame.origin, Materials::surface_of(frame, compiled)};
  }

  template <Effects effects>
  static const Mesh& mesh_of(const Mesh& mesh, [[maybe_unused]] std::uint32_t first_vertex) {
    if constexpr (effects.has(effect::skins)) return skins::begin_meshlet(mesh, first_vertex);
    return mesh;
  }

  /// Returns the batch of a meshlet, with the data that only drawing needs.
  template <Effects effects>
  static BatchOf<effects> batch_for(const FrameState& frame, std::uint32_t instance, std::uint32_t first_vertex,
                                    std::uint32_t cache) {
    if constexpr (effects.has(effect::environment)) {
      return {batch_of<effects>(frame, instance, first_vertex, cache),
              environment::reflections_of(frame, instance, cache)};
    } else {
      return batch_of<effects>(frame, instance, first_vertex, cache);
    }
  }

  /// Transforms a meshlet's vertices. Returns false if some vertex needs the clipping path.
  template <Effects effects>
  static bool transform(FrameState& frame, const Batch& batch, const MeshletRange& range, std::uint32_t cache) {
    if constexpr (effects.has(effect::statistics)) frame.statistics.vertices += range.vertex_count;
    move<effects>(batch, range);
    if constexpr (effects.has(effect::outlines)) {
      if (is_outline(*batch.instance)) {
        if constexpr (effects.has(effect::statistics)) {
          frame.statistics.work[WorkKind::hull_vertices] += range.vertex_count;
        }
        return transform_hull<effects.has(effect::orthographic), depth_format(effects)>(
            *batch.instance, *batch.mesh, frame.origin, range.first_vertex, range.vertex_count, frame.vertices + cache);
      }
    }
    return transform_vertices<raster_effects(effects)>(*batch.instance, *batch.mesh, frame.origin, range.first_vertex,
                                                       range.vertex_count, frame.vertices + cache);
  }

  /// Moves the positions of a skin, and its normals if they move vertices (outlines) or are read later.
  template <Effects effects>
  static void move([[maybe_unused]] const Batch& batch, [[maybe_unused]] const MeshletRange& range) {
    if constexpr (effects.has(effect::skins)) {
      skins::move_positions(*batch.mesh, range);
      if constexpr (effects.any(effect::outlines | effect::pixel_shading)) skins::move_normals(*batch.mesh, range);
    }
  }

  template <Effects effects>
  static void shade(FrameState& frame, const BatchOf<effects>& batch, const MeshletRange& range, std::uint32_t cache) {
    if constexpr (effects.has(effect::skins) && !effects.any(effect::outlines | effect::pixel_shading)) {
      skins::move_normals(*batch.mesh, range);
    }
    if constexpr (effects.has(effect::environment)) {
      if (batch.reflections != nullptr) {
        environment::reflect<effects.has(effect::orthographic)>(frame, batch, range);
        if constexpr (effects.has(effect::statistics))
          frame.statistics.work[WorkKind::mirroring_vertices] += range.vertex_count;
      }
    }
    if constexpr (has_vertex_colours(effects)) {
      if (batch.colours != nullptr && !has_colours_of_mesh<effects>(*batch.instance)) {
        if constexpr (effects.has(effect::statistics))
          frame.statistics.work[WorkKind::lit_vertices] += range.vertex_count;
        if constexpr (effects.any(effect::vertex_light)) {
          if (local_light::shade<effects>(frame, batch, range, cache)) return;
        }
        shade_vertices<effects&(effect::lighting | effect::vertex_colours)>(
            *batch.instance, *batch.mesh, range.first_vertex, range.vertex_count, frame.colours + cache);
      }
    }
  }

  /// Computes the vertex colours in shadow, which bins keep next to the colours of `shade`.
  template <Effects effects>
  static void retain_shadow(FrameState& frame, const BatchOf<effects>& batch, const MeshletRange& range,
                            std::uint32_t cache) {
    if constexpr (effects.has(effect::shadows)) {
      shadows::shade_retained(frame, batch, [&] { shade<effects>(frame, batch, range, cache); });
    }
  }

  /// Finds the strips that the front faces of each meshlet touch.
  template <Effects effects>
  static void survey(FrameState& frame) {
    for_each_meshlet<effects>(frame, [&](std::uint32_t number, std::uint32_t instance, std::uint32_t meshlet) {
      if constexpr (methods::culls(effects)) {
        frame.extents[number] = Extent::none();
        if (MethodStage::is_left_out<effects>(frame, number, instance, meshlet)) return;
      }
      const MeshletRange range = meshlet_range(frame.scene->meshes[frame.instances[instance].mesh], meshlet);
      const auto batch = batch_for<effects>(frame, instance, range.first_vertex, 0);
      const bool all_narrow = transform<effects>(frame, batch, range, 0);
      Rect box{INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN};
      Facing<effects>::for_each(batch, range.triangles, all_narrow, [&](std::uint32_t, const auto& covered) {
        const Rect pixels = covered.box();
        box = {std::min(box.left, pixels.left), std::min(box.top, pixels.top), std::max(box.right, pixels.right),
               std::max(box.bottom, pixels.bottom)};
        return true;
      });
      if constexpr (effects.has(effect::edges)) {
        if (edges::has_apron<effects>(frame)) box = edges::box_with_apron(box);
      }
      frame.extents[number] = frame.grid.extent_of(box);
    });
  }

  /// Transforms all vertices once and writes each front face into the lists of its strips. Returns false if the memory
  /// of the lists is too small.
  template <Effects effects>
  static bool fill_bins(FrameState& frame) {
    std::uint32_t retained = 0;
    std::uint16_t batches = 0;
    bool room = true;
    for_each_meshlet<effects>(
        frame, [&]([[maybe_unused]] std::uint32_t number, std::uint32_t instance, std::uint32_t meshlet) {
          if (!room) return;
          if constexpr (methods::culls(effects)) {
            if (MethodStage::is_left_out<effects>(frame, number, instance, meshlet)) return;
          }
          const MeshletRange range = meshlet_range(frame.scene->meshes[frame.instances[instance].mesh], meshlet);
          const auto batch = batch_for<effects>(frame, instance, range.first_vertex, retained);
          const bool all_narrow = transform<effects>(frame, batch, range, retained);
          if (!list_facing<effects>(frame, batch, range, all_narrow, batches)) {
            room = false;
            return;
          }
          if (!frame.bins.has_newest(batches)) return;
          shade<effects>(frame, batch, range, retained);
          retain_shadow<effects>(frame, batch, range, retained);
          frame.batches[batches++] = retained_batch(instance, meshlet, retained, all_narrow);
          retained += range.vertex_count;
        });
    return room;
  }

  static bool list(FrameState& frame, const Extent& extent, std::uint16_t batch, std::uint16_t triangle) {
    return list_in(frame, frame.grid.strips_of_extent(extent), batch, triangle);
  }
  /// Adds a triangle to the lists of all strips with pixels that it can cover. Inlined, because the compiler would
  /// otherwise call it for each triangle in programs with many pipelines.
  template <class Pixels>
  [[gnu::always_inline]] static bool list(FrameState& frame, const Pixels& covered, std::uint16_t batch,
                                          std::uint16_t triangle) {
    if (frame.grid.across() != 1) return list_in(frame, frame.grid.strips_of(covered.box()), batch, triangle);
    const StripGrid::Range rows = frame.grid.rows_of(covered.top(), covered.bottom());
    for (std::int32_t row = rows.first; row < rows.end; ++row) {
      if (!frame.bins.add(static_cast<std::uint32_t>(row), batch, triangle)) return false;
    }
    return true;
  }
  /// Lists a meshlet's front faces in the fastest way for it. Returns false if the memory of the lists is too small.
  template <Effects effects>
  static bool list_facing(FrameState& frame, const BatchOf<effects>& batch, const MeshletRange& range, bool all_narrow,
                          std::uint16_t number) {
    using Assembler = AssemblerFor<effects>;
    bool has_apron = false, is_hull = false;
    if constexpr (effects.has(effect::edges)) has_apron = edges::has_apron<effects>(frame);
    if constexpr (effects.has(effect::outlines)) is_hull = is_outline(*batch.instance);
    if ((all_narrow || Assembler::kUnclipped) && frame.grid.across() == 1 && !has_apron && !is_hull &&
        !Assembler::Narrow::shows_both_sides(batch)) {
      FaceLists faces(frame.bins, frame.grid.vertex_rows(frame.plan.strip_rows), number, batch.vertices,
                      batch.first_vertex);
      return list_faces(faces, range.triangles.data(), static_cast<std::uint32_t>(range.triangles.size()));
    }
    return Facing<effects>::for_each(
        batch, range.triangles, all_narrow, [&](std::uint32_t triangle, const auto& covered) {
          const auto index = static_cast<std::uint16_t>(triangle);
          if constexpr (effects.has(effect::edges)) {
            if (has_apron) {
              return list_in(frame, frame.grid.strips_of(edges::box_with_apron(covered.box())), number, index);
            }
          }
          return list(frame, covered, number, index);
        });
  }
  static bool list_in(FrameState& frame, const Rect& strips, std::uint16_t batch, std::uint16_t triangle) {
    for (std::int32_t row = strips.top; row < strips.bottom; ++row) {
      for (std::int32_t column = strips.left; column < strips.right; ++column) {
        const auto strip = static_cast<std::uint32_t>(row * frame.grid.across() + column);
        if (!frame.bins.add(strip, batch, triangle)) return false;
      }
    }
    return true;
  }
};

}  // namespace zstrip::detail
