// Triangles that leave the narrow range or the depth range: transformed again in full width, clipped, drawn in parts.
#pragma once

#include <algorithm>
#include <cstdint>
#include <type_traits>

#include "zstrip/effects.hpp"
#include "zstrip/effects/outlines/outline.hpp"
#include "zstrip/effects/pixel_shading/lit_corners.hpp"
#include "zstrip/geometry/clip.hpp"
#include "zstrip/geometry/project.hpp"
#include "zstrip/raster/attributes.hpp"
#include "zstrip/raster/fragment.hpp"
#include "zstrip/raster/polygon.hpp"
#include "zstrip/raster/span_triangle.hpp"

namespace zstrip::detail {

/// Counts a triangle while it lives: as drawn in the first strip that it touches, so that strips add up to the frame,
/// and as covering in every strip where it turns out to have fragments. Without statistics it is nothing.
template <bool statistics>
class CountedTriangle {
 public:
  CountedTriangle(const StripTarget& target, std::int32_t first_column, std::int32_t first_row) {
    if constexpr (statistics) {
      counts_ = target.statistics;
      fragments_before_ = counts_->fragments;
      if (std::max(first_row, target.first_row) >= target.area.top &&
          std::max(first_column, target.first_column) >= target.area.left) {
        ++counts_->drawn;
      }
    }
  }
  CountedTriangle(const CountedTriangle&) = delete;
  CountedTriangle& operator=(const CountedTriangle&) = delete;
  ~CountedTriangle() {
    if constexpr (statistics) {
      if (counts_->fragments != fragments_before_) ++counts_->covering;
    }
  }

 private:
  Statistics* counts_ = nullptr;
  std::uint32_t fragments_before_ = 0;
};

template <Effects effects>
struct ClippedAssembler {
  static constexpr bool kOrthographic = effects.has(effect::orthographic);
  static constexpr bool kStatistics = effects.has(effect::statistics);
  static constexpr bool kTextures = effects.has(effect::textures);
  static constexpr DepthMode kDepth = depth_mode(effects);
  static constexpr std::int32_t kPerspective = perspective_run(effects);
  using Attributes = VertexAttributes<effects>;
  using Batch = BatchOf<effects>;
  using StripTarget = TargetOf<effects>;  // with what the depth mode and fragments need
  template <Shade shade>
  using SurfaceOf = std::conditional_t<shade == Shade::fragments, FragmentSurface<effects>, Surface>;
  template <Shade shade>
  static constexpr bool kMayBeLit = effects.has(effect::pixel_shading) && shade == Shade::fragments;

  /// Planes start at vertex a and round there. Rotated so that the vertex of least order becomes a, a triangle has the
  /// same depths and colours whichever of its vertices comes first.
  template <class Order, class Corner>
  static void rotate_to_first(const Order& order, Corner& ia, Corner& ib, Corner& ic) {
    const auto a = order(ia), b = order(ib), c = order(ic);
    const Corner first = ia;
    if (b < a && b < c) {
      ia = ib, ib = ic, ic = first;
    } else if (c < a) {
      ia = ic, ic = ib, ib = first;
    }
  }

  template <Shade shade, class Target>
  static void draw_spans(const Target& target, const RasterVertex (&v)[3], const SurfaceOf<shade>& surface,
                         bool narrow) {
    if constexpr (shade == Shade::fragments) {
      draw_fragment_triangle<effects>(target, v[0], v[1], v[2], surface, narrow);
    } else {
      draw_span_triangle<shade, kOrthographic, kStatistics, kDepth, kPerspective>(target, v[0], v[1], v[2], surface,
                                                                                  narrow);
    }
  }

  static ClipVertex clip_vertex(const Batch& batch, std::uint32_t index) {
    const Position& p = batch.mesh->positions[index];
    const auto wide = [&p](const LinearForm& form) { return std::int64_t{form.at(p)} * (1 << kClipBits); };
    ClipVertex vertex{wide(batch.instance->x), wide(batch.instance->y), wide(batch.instance->w), 0, 0, 0, 0, 0};
    if constexpr (effects.has(effect::outlines)) {
      if (is_outline(*batch.instance)) {
        const HullVertex moved = hull_vertex<kOrthographic>(*batch.instance, *batch.mesh, index);
        vertex.w = std::int64_t{moved.w} * (1 << kClipBits);
        vertex.u = moved.right, vertex.v = moved.down;
      }
    }
    return vertex;
  }

  /// Along the viewing direction, in the instance's own scale.
  static std::int32_t distance_of(const Batch& batch, std::uint32_t index) {
    if constexpr (effects.has(effect::outlines)) {
      if (is_outline(*batch.instance)) return hull_vertex<kOrthographic>(*batch.instance, *batch.mesh, index).w;
    }
    return batch.instance->w.at(batch.mesh->positions[index]);
  }

  static RasterVertex projected(const Batch& batch, const ClipVertex& v) {
    WidePosition p = project_wide<kOrthographic, reciprocal_kind(effects)>(*batch.instance, batch.origin, v);
    if constexpr (kDepth.format != DepthFormat::z16) {
      p.depth = project_wide_depth<kOrthographic, kDepth.format>(*batch.instance, batch.origin, v);
    }
    if constexpr (effects.has(effect::outlines)) {
      // Not beyond the guard band: both neighbours stop there.
      const auto moved = [](std::int32_t from, std::int32_t by) {
        constexpr std::int32_t kGuard = std::int32_t{1} << kGuardBits;
        return std::clamp(from + by, -kGuard, kGuard);
      };
      if (is_outline(*batch.instance)) return {moved(p.x, v.u), moved(p.y, v.v), p.depth, v.r, v.g, v.b, 0, 0};
    }
    return {p.x, p.y, p.depth, v.r, v.g, v.b, v.u, v.v};
  }

  /// The path for triangles that leave the narrow range or the depth range: transforms its vertices again, in full
  /// width. False if nothing of it faces the viewer.
  template <Shade shade>
  [[gnu::noinline]] static bool clip(const Batch& batch, const Triangle& triangle, RasterPolygon& polygon) {
    ClipPolygon clipped;
    clipped.count = 3;
    std::uint32_t indices[3] = {triangle.a, triangle.b, triangle.c};
    const auto by_position = [&batch](std::uint32_t index) {
      const Position& p = batch.mesh->positions[index];
      return std::int64_t{p.x} * (std::int64_t{1} << 32) + std::int64_t{p.y} * 65536 + p.z;
    };
    rotate_to_first(by_position, indices[0], indices[1], indices[2]);
    for (int i = 0; i < 3; ++i) {
      clipped.vertices[i] = clip_vertex(batch, indices[i]);
      Attributes::template load<shade>(batch, indices[i], clipped.vertices[i]);
      if constexpr (kMayBeLit<shade>) {
        if (has_lit_fragments(batch.instance->shade)) {
          set_corner(clipped.vertices[i], indices[i] == triangle.a ? 0 : indices[i] == triangle.b ? 1 : 2);
        }
      }
    }
    if constexpr (kOrthographic) {
      clip_orthographic(clipped, *batch.instance);
    } else {
      clip_perspective(clipped, *batch.instance);
    }
    for (int i = 0; i < clipped.count; ++i) polygon.append(projected(batch, clipped.vertices[i]));
    return polygon.face_front(batch.instance->double_sided);
  }

  /// Of a triangle of a clipped one.
  static void take_corners(const StripTarget& target, const Batch& batch, const Triangle& triangle,
                           RasterVertex (&vertices)[3], LitSurface& surface) {
    LitCorner corners[3];
    RasterVertex colours[3] = {};
    const std::uint32_t indices[3] = {triangle.a, triangle.b, triangle.c};
    for (int i = 0; i < 3; ++i) {
      corners[i] = lit_corner<effects>(*batch.mesh, indices[i], target.light);
      Attributes::template load<Shade::fragments>(batch, indices[i], colours[i]);
    }
    detail::take_corners(vertices, corners, colours, surface);
  }

  /// Cannot be inlined: what clipping needs of the stack, the most of all, is free again here.
  template <Shade shade>
  [[gnu::noinline]] static void draw_polygon(const StripTarget& target, const Batch& batch, const Triangle& triangle,
                                             RasterPolygon& polygon, const Rect& box) {
    SurfaceOf<shade> surface{batch.surface};
    surface.flat_colour = Attributes::template flat_colour<shade>(batch, triangle);
    if constexpr (kStatistics) ++target.statistics->clipped;
    const CountedTriangle<kStatistics> counted(target, box.left, box.top);
    RasterVertex corner[3];
    while (polygon.cut_triangle(corner)) {
      Attributes::template take_first_colour<shade>(batch, triangle, corner);
      if constexpr (kMayBeLit<shade>) {
        if (has_lit_fragments(batch.instance->shade)) take_corners(target, batch, triangle, corner, surface);
      }
      TriangleParts parts(polygon, corner, target.area);
      for (Rect part; parts.next(part);) {
        draw_spans<shade>(part_of<DepthCell<kDepth.format>>(target, part), corner, surface, false);
      }
    }
  }

  template <Shade shade>
  [[gnu::noinline]] static void draw_clipped(const StripTarget& target, const Batch& batch, const Triangle& triangle) {
    RasterPolygon polygon;
    if (!clip<shade>(batch, triangle, polygon)) return;
    const Rect box = polygon.box();
    const Rect& area = target.area;
    if (std::max(box.left, area.left) >= std::min(box.right, area.right) ||
        std::max(box.top, area.top) >= std::min(box.bottom, area.bottom)) {
      return;
    }
    draw_polygon<shade>(target, batch, triangle, polygon, box);
  }
};

}  // namespace zstrip::detail
