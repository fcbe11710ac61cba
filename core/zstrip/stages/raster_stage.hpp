// The raster stage of a strip: draws the triangles of the meshlets that touch it, or of its bin.
#pragma once

#include <cstdint>
#include <span>

#include "zstrip/stages/geometry_stage.hpp"
#include "zstrip/stages/method_stage.hpp"
#include "zstrip/stages/seen_faces.hpp"
#include "zstrip/visibility/traits.hpp"

namespace zstrip::detail {

struct RasterStage {
  /// Assigns geometry to strips: by the order of a method, by bins, or by the extents of meshlets.
  template <Effects effects>
  static Status assign_to_strips(FrameState& frame, [[maybe_unused]] const Camera& camera) {
    if constexpr (effects.has(effect::statistics)) frame.statistics.triangles = count(*frame.scene).triangles;
    if constexpr (methods::culls(effects) && effects.has(effect::statistics)) {
      MethodStage::count_culled<effects>(static_cast<MethodFrameState&>(frame));
    }
    if constexpr (sorts_triangles(effects)) {
      return MethodStage::order_triangles<effects>(static_cast<MethodFrameState&>(frame), camera);
    }
    if (frame.extents == nullptr) return {};
    if constexpr (effects.has(effect::bins)) {
      if (frame.mode == Mode::binned) {
        if (GeometryStage::fill_bins<effects>(frame)) return {};
        frame.mode = Mode::streamed;
        ++frame.bin_overflows;
      }
    }
    GeometryStage::survey<effects>(frame);
    return {};
  }

  /// Draws from bins or in a method's order, or else streams: every meshlet that touches the strip, through the cache.
  template <Effects effects>
  static void draw_triangles(FrameState& frame, const StripTarget& target, std::uint16_t strip) {
    if constexpr (effects.has(effect::bins)) {
      if (frame.mode == Mode::binned) return draw_binned<effects>(frame, target, strip);
    }
    if constexpr (sorts_triangles(effects)) {
      return MethodStage::draw_sorted<effects>(static_cast<MethodFrameState&>(frame), target, strip);
    }
    const StripGrid::Place place = frame.grid.place_of(strip);
    const auto draw_meshlet = [&](std::uint32_t number, std::uint32_t instance, std::uint32_t meshlet) {
      if (frame.extents != nullptr && !frame.grid.touches(frame.extents[number], place)) return;
      if constexpr (methods::culls(effects)) {
        if (MethodStage::is_left_out<effects>(frame, number, instance, meshlet)) return;
      }
      const MeshletRange range = meshlet_range(frame.scene->meshes[frame.instances[instance].mesh], meshlet);
      const auto batch = GeometryStage::batch_for<effects>(frame, instance, range.first_vertex, 0);
      const bool all_narrow = GeometryStage::transform<effects>(frame, batch, range, 0);
      const auto shade = [&](std::uint32_t from, std::uint32_t count) {
        GeometryStage::shade<effects>(frame, batch, {range.first_vertex + from, count, {}}, from);
      };
      const auto& complete = Materials::instance_target<effects>(frame, target, *batch.instance);
      const auto draw = [&](std::span<const Triangle> triangles) {
        AssemblerFor<effects>::draw(complete, batch, triangles, all_narrow);
      };
      if constexpr (lights_seen_vertices(effects)) {
        // A single strip shows all front faces: finding them pays only for skins, whose light takes more.
        const bool pays = frame.extents != nullptr || batch.mesh->skinning != nullptr;
        if (pays && lights_seen_vertices<effects>(batch, range, all_narrow)) {
          return for_seen_faces<effects>(batch, range, complete.area, shade, draw);
        }
      }
      shade(0, range.vertex_count);
      draw(range.triangles);
    };
    if constexpr (methods::hides_by_bounds(effects)) {
      MethodStage::draw_seen_first<effects>(static_cast<MethodFrameState&>(frame), target, draw_meshlet);
    } else {
      GeometryStage::for_each_meshlet<effects>(frame, draw_meshlet);
    }
  }

  template <Effects effects>
  static void draw_binned(FrameState& frame, const StripTarget& target, std::uint16_t strip) {
    AssemblerFor<effects>::begin_listed(frame.bins, target.area);
    for (BinReader list(frame.bins, strip); list.next_batch();) {
      const RetainedBatch& retained = frame.batches[list.batch()];
      const MeshletRange range =
          meshlet_range(frame.scene->meshes[frame.instances[retained.instance].mesh], retained.meshlet);
      const auto batch =
          GeometryStage::batch_for<effects>(frame, retained.instance, range.first_vertex, retained.first_vertex);
      // Clipping and lighting by pixel read the mesh's moved vertices, not only the cache.
      if (!retained.all_narrow || effects.has(effect::pixel_shading)) GeometryStage::move<effects>(batch, range);
      AssemblerFor<effects>::draw_listed(Materials::instance_target<effects>(frame, target, *batch.instance), batch,
                                         range.triangles, list, retained.all_narrow);
    }
  }

  /// Calls draw(target, strip) for the strips of the frame in `area`, in `pixels` and `depth` without gaps.
  template <class Draw>
  static void for_each_part(FrameState& frame, const Rect& area, std::uint16_t* pixels, std::uint16_t* depth,
                            const Draw& draw) {
    const Rect strips = frame.grid.strips_of_picture(area);
    for (std::int32_t row = strips.top; row < strips.bottom; ++row) {
      for (std::int32_t column = strips.left; column < strips.right; ++column) {
        const auto strip = static_cast<std::uint16_t>(row * frame.grid.across() + column);
        const Rect part = frame.plan.strip_area(strip, frame.view).cut_to(area).cut_to(frame.bounds);
        StripTarget target = target_at(frame, part);
        const std::int32_t first = (part.top - area.top) * area.width() + (part.left - area.left);
        target.depth = depth + first;
        target.colour = pixels + first;
        target.depth_stride = target.colour_stride = area.width();
        draw(target, strip);
      }
    }
  }
};

}  // namespace zstrip::detail
