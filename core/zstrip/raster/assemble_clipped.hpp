// Clips triangles that leave the narrow range or the depth range, and draws the parts.
#pragma once

#include <algorithm>
#include <cstdint>
#include <type_traits>

#include "zstrip/effects.hpp"
#include "zstrip/kernels/triangle_planes.hpp"
#include "zstrip/raster/attributes.hpp"
#include "zstrip/raster/clip_triangle.hpp"
#include "zstrip/raster/fragment.hpp"
#include "zstrip/raster/lit_corners.hpp"
#include "zstrip/raster/polygon.hpp"
#include "zstrip/raster/span_triangle.hpp"

namespace zstrip::detail {

/// Counts a triangle as drawn in the first strip that it touches, so that strips add up to the frame, and as covering
/// in every strip in which it has fragments. Does nothing without statistics.
template <bool statistics, Shade shade>
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
      const std::uint32_t fragments = counts_->fragments - fragments_before_;
      if (fragments == 0) return;
      ++counts_->covering;
      if constexpr (shade >= Shade::textured) {
        constexpr bool kStaged = shade == Shade::fragments, kUnlit = shade == Shade::textured;
        ++counts_->work[kStaged  ? WorkKind::staged_triangles
                        : kUnlit ? WorkKind::textured_triangles
                                 : WorkKind::lit_textured_triangles];
        counts_->work[kStaged  ? WorkKind::staged_fragments
                      : kUnlit ? WorkKind::textured_fragments
                               : WorkKind::lit_textured_fragments] += fragments;
      }
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
  using StripTarget = TargetOf<effects>;  // with the settings for depth mode and fragments
  /// Words pay for triangles with many planes. Plain ones, which are drawn by spans only if they are large, are faster
  /// in 64 bits; beside the others they share their code.
  using Planes = std::conditional_t<effects.any(effect::fragments), TrianglePlanes, PlaneSetup>;
  template <Shade shade>
  using SurfaceOf = std::conditional_t<shade == Shade::fragments, FragmentSurface<effects>, Surface>;
  template <Shade shade>
  static constexpr bool kMayBeLit = effects.has(effect::pixel_shading) && shade == Shade::fragments;

  /// `narrow`: all coordinates are within kNarrowLimit; a bool or std::true_type.
  template <Shade shade, class Target, class Narrow>
  static void draw_spans(const Target& target, const RasterVertex (&v)[3], const SurfaceOf<shade>& surface,
                         Narrow narrow) {
    if constexpr (shade == Shade::fragments) {
      draw_fragment_triangle<effects>(target, v[0], v[1], v[2], surface, narrow);
    } else {
      draw_span_triangle<shade, kOrthographic, kStatistics, kDepth, kPerspective, Planes>(target, v[0], v[1], v[2],
                                                                                          surface, narrow);
    }
  }

  /// Not inlined: the stack that it takes is free again while the polygon is drawn. Only the loading of vertices
  /// depends on the shade.
  template <Shade shade>
  [[gnu::noinline]] static bool clip(const Batch& batch, const Triangle& triangle, RasterPolygon& polygon) {
    ClipPolygon clipped;
    std::uint32_t indices[3];
    ClipperFor<effects>::begin(batch, triangle, clipped, indices);
    for (int i = 0; i < 3; ++i) {
      Attributes::template load<shade>(batch, indices[i], clipped.vertices[i]);
      if constexpr (kMayBeLit<shade>) {
        if (has_lit_fragments(batch.instance->shade)) {
          set_corner(clipped.vertices[i], indices[i] == triangle.a ? 0 : indices[i] == triangle.b ? 1 : 2);
        }
      }
    }
    return ClipperFor<effects>::finish(batch, clipped, polygon);
  }

  /// Reads the corners of the triangle of which `vertices` are a part.
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

  /// Not inlined: clipping needs the most stack of all, and that stack is free again here.
  template <Shade shade>
  [[gnu::noinline]] static void draw_polygon(const StripTarget& target, const Batch& batch, const Triangle& triangle,
                                             RasterPolygon& polygon, const Rect& box) {
    SurfaceOf<shade> surface{batch.surface};
    surface.flat_colour = Attributes::template flat_colour<shade>(batch, triangle);
    if constexpr (kStatistics) ++target.statistics->clipped;
    const CountedTriangle<kStatistics, shade> counted(target, box.left, box.top);
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
    if (ClipperFor<effects>::misses_rows(batch, triangle, target.area)) return;
    if constexpr (kStatistics) ++target.statistics->work[WorkKind::clips];
    RasterPolygon polygon;
    if (!clip<shade>(batch, triangle, polygon)) return;
    const Rect box = polygon.box();
    if (!box.touches(target.area)) return;
    draw_polygon<shade>(target, batch, triangle, polygon, box);
  }
};

}  // namespace zstrip::detail
