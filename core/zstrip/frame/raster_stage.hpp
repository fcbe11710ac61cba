// The raster stage of a strip: quadrics, lines, then the triangles of the meshlets or of the strip's bin.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "zstrip/effects/csg/csg_stage.hpp"
#include "zstrip/effects/lines/line_fill.hpp"
#include "zstrip/effects/quadrics/quadric_fill.hpp"
#include "zstrip/effects/quadrics/quadric_shade.hpp"
#include "zstrip/frame/geometry_stage.hpp"

namespace zstrip {

struct Frame::Access::Raster {
  template <Effects effects>
  static void draw_surfaces(Frame& frame, const detail::StripTarget& target, std::uint16_t strip) {
    // They are opaque: what blends comes after them. Products take what they find in the z-buffer for their own.
    if constexpr (effects.has(effect::csg)) Csg::draw<effects>(frame, target, strip);
    if constexpr (effects.has(effect::quadrics)) draw_quadrics<effects>(frame, target);
    if constexpr (effects.has(effect::lines)) draw_lines<effects>(frame, target);
    draw_triangles<effects>(frame, target, strip);
  }

  template <Effects effects>
  static void draw_triangles(Frame& frame, const detail::StripTarget& target, std::uint16_t strip) {
    if constexpr (effects.has(effect::bins)) {
      if (frame.mode_ == Mode::binned) return draw_binned<effects>(frame, target, strip);
    }
    if constexpr (sorts_triangles(effects)) {
      return Methods::draw_sorted<effects>(static_cast<FrameWithMethod&>(frame), target, strip);
    }
    draw_streamed<effects>(frame, target, strip);
  }

  template <Effects effects>
  static void draw_streamed(Frame& frame, const detail::StripTarget& target, std::uint16_t strip) {
    const std::int32_t row = strip / frame.grid_.across();
    const std::int32_t column = strip % frame.grid_.across();
    const auto draw_meshlet = [&](std::uint32_t number, std::uint32_t instance, std::uint32_t meshlet) {
      if (frame.extents_ != nullptr && !frame.grid_.touches(frame.extents_[number], row, column)) return;
      if constexpr (effects.has(method::culling)) {
        if (Methods::is_left_out<effects>(frame, number, instance, meshlet)) return;
      }
      const Geometry::MeshletRange range =
          Geometry::meshlet_range(frame.scene_->meshes[frame.instances_[instance].mesh], meshlet);
      const auto batch = Geometry::batch_for<effects>(frame, instance, range.first_vertex, 0);
      const bool all_narrow = Geometry::transform<effects>(frame, batch, range, 0);
      Geometry::shade<effects>(frame, batch, range, 0);
      Materials::with_settings<effects>(frame, target, *batch.instance, [&](const auto& complete) {
        Assembler<effects>::draw(complete, batch, range.triangles, all_narrow);
      });
    };
    if constexpr (effects.has(method::hierarchical_z)) {
      Methods::draw_seen_first<effects>(static_cast<FrameWithMethod&>(frame), target, draw_meshlet);
    } else {
      Geometry::for_each_meshlet<effects>(frame, draw_meshlet);
    }
  }

  template <Effects effects>
  static void draw_binned(Frame& frame, const detail::StripTarget& target, std::uint16_t strip) {
    frame.bins_.for_each_run(strip, [&](std::uint16_t number, const std::uint16_t* triangles, std::uint32_t count) {
      const detail::RetainedBatch& retained = frame.batches_[number];
      const Geometry::MeshletRange range =
          Geometry::meshlet_range(frame.scene_->meshes[frame.instances_[retained.instance].mesh], retained.meshlet);
      const auto batch =
          Geometry::batch_for<effects>(frame, retained.instance, range.first_vertex, retained.first_vertex);
      Materials::with_settings<effects>(frame, target, *batch.instance, [&](const auto& complete) {
        Assembler<effects>::draw_listed(complete, batch, range.triangles, {triangles, count}, retained.all_narrow);
      });
    });
  }

  template <Effects effects>
  static void draw_quadrics(Frame& frame, const detail::StripTarget& target) {
    constexpr bool kOrthographic = effects.has(effect::orthographic);
    const std::int64_t offset = kOrthographic ? std::int64_t{frame.origin_.depth_offset} : -frame.fit_.offset;
    const detail::CompiledQuadric* const quadrics = quadrics_of(frame, *frame.scene_);
    for (std::size_t i = 0; i < frame.scene_->quadrics.size(); ++i) {
      const detail::CompiledQuadric& quadric = quadrics[i];
      if (!quadric.visible) continue;
      detail::QuadricShade<effects> shade{quadric, Materials::texture_of(frame, quadric.material)};
      if constexpr (effects.has(effect::fog)) {
        if (frame.scene_->fog != nullptr) shade.fog = &effect_block(frame).fog();
        shade.depth_offset = kOrthographic ? offset : -offset;
      }
      if constexpr (effects.has(effect::dithered_colours)) {
        shade.dither = {quadric.anchor_x - target.view_left, quadric.anchor_y - target.view_top,
                        dithers_colours(frame.view_)};
      }
      Materials::with_depth<effects>(frame, target, quadric.material, [&](const auto& complete) {
        detail::QuadricFill<effects>::draw(complete, quadric, offset, shade);
      });
    }
  }

  template <Effects effects>
  static void draw_lines(Frame& frame, const detail::StripTarget& target) {
    const Scene& scene = *frame.scene_;
    const std::span<const detail::CompiledLines> all = lines_of(frame, scene);
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (!all[i].instance.visible) continue;
      const LineSet& lines = scene.lines[i];
      detail::LineShade<effects> shade;
      if constexpr (effects.has(effect::fog)) {
        if (scene.fog != nullptr) shade.fog = &effect_block(frame).fog();
        shade.depth_offset =
            effects.has(effect::orthographic) ? std::int64_t{frame.origin_.depth_offset} : frame.fit_.offset;
      }
      if constexpr (effects.has(effect::dithered_colours)) {
        shade.dither = {-target.view_left, -target.view_top, dithers_colours(frame.view_)};
      }
      if constexpr (effects.has(effect::supersampled)) {
        shade.grid = {static_cast<std::int32_t>(sample_columns(frame.view_)),
                      static_cast<std::int32_t>(sample_rows(frame.view_))};
      }
      Materials::with_depth<effects>(frame, target, lines.material, [&](const auto& complete) {
        detail::LineFill<effects>::draw(complete, all[i], lines, scene.meshes[lines.mesh], frame.origin_, shade);
      });
    }
  }

  /// The part of the frame in `area`, over what is in `pixels` and `depth`, which have no gaps.
  template <Effects effects>
  static void draw_over(Frame& frame, const Rect& area, std::uint16_t* pixels, std::uint16_t* depth) {
    const Rect strips = frame.grid_.strips_of_picture(area);
    for (std::int32_t row = strips.top; row < strips.bottom; ++row) {
      for (std::int32_t column = strips.left; column < strips.right; ++column) {
        const auto strip = static_cast<std::uint16_t>(row * frame.grid_.across() + column);
        const Rect cut = frame.plan_.strip_area(strip, frame.view_);
        const Rect part{std::max({cut.left, area.left, frame.bounds_.left}),
                        std::max({cut.top, area.top, frame.bounds_.top}),
                        std::min({cut.right, area.right, frame.bounds_.right}),
                        std::min({cut.bottom, area.bottom, frame.bounds_.bottom})};
        detail::StripTarget target = target_at(frame, part);
        const std::int32_t first = (part.top - area.top) * area.width() + (part.left - area.left);
        target.depth = depth + first;
        target.colour = pixels + first;
        target.depth_stride = target.colour_stride = area.width();
        draw_surfaces<effects>(frame, target, strip);
      }
    }
  }
};

}  // namespace zstrip
