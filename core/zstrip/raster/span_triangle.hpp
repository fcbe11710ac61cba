// Triangles of any size, row by row: exact edges, one span a row.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "zstrip/raster/edge_walk.hpp"
#include "zstrip/raster/span_fill.hpp"

namespace zstrip::detail {

/// What the pixels of a triangle need besides its vertices.
struct Surface {
  std::uint16_t flat_colour;
  TextureView texture;
  std::int64_t depth_offset;  ///< DepthFit::offset
};

template <class Integer, class FillSpan>
void walk_spans(const StripTarget& target, const RasterVertex& a, const RasterVertex& b, const RasterVertex& c,
                const FillSpan& fill) {
  const RasterVertex* top = &a;
  const RasterVertex* middle = &b;
  const RasterVertex* bottom = &c;
  if (middle->y < top->y) std::swap(middle, top);
  if (bottom->y < middle->y) std::swap(bottom, middle);
  if (middle->y < top->y) std::swap(middle, top);

  const std::int32_t end = std::min(bottom->y >> 4, target.area.bottom);
  std::int32_t row = std::max(top->y >> 4, target.area.top);
  if (row >= end) return;
  // The middle vertex is right of the long edge if the area of top, bottom, middle is positive (y down).
  const bool middle_is_right = signed_area(*top, *middle, *bottom) < 0;
  EdgeWalk<Integer> long_edge(top->x, top->y, bottom->x, bottom->y, row);
  for (int half = 0; half < 2; ++half) {
    const RasterVertex& from = half == 0 ? *top : *middle;
    const RasterVertex& to = half == 0 ? *middle : *bottom;
    const std::int32_t half_end = std::min(to.y >> 4, end);
    if (row >= half_end) continue;
    EdgeWalk<Integer> short_edge(from.x, from.y, to.x, to.y, row);
    for (; row < half_end; ++row) {
      const std::int32_t whole_left = middle_is_right ? long_edge.pixel : short_edge.pixel;
      const std::int32_t whole_right = middle_is_right ? short_edge.pixel : long_edge.pixel;
      const std::int32_t left = std::max(whole_left, target.area.left);
      const std::int32_t right = std::min(whole_right, target.area.right);
      if (left < right) fill(row, left, right, whole_left, whole_right);
      long_edge.next_row();
      short_edge.next_row();
    }
  }
}

/// A triangle set up: its anchor, its depth, and its spans in a strip.
template <DepthMode mode>
struct SpanTriangle {
  SpanTriangle(const TargetFor<mode>& target, const RasterVertex& v0, const RasterVertex& v1, const RasterVertex& v2)
      : area(signed_area(v0, v1, v2)),
        anchor_x(std::max(std::min({v0.x, v1.x, v2.x}) >> 4, target.view_left)),
        anchor_y(std::max(std::min({v0.y, v1.y, v2.y}) >> 4, target.view_top)),
        setup(v0, v1, v2, area, anchor_x, anchor_y),
        depth(setup, v0, v1, v2, area, anchor_x, anchor_y),
        rule(target, v0, v1, v2, area) {}

  /// Calls fill(run, depth plane) for all runs in the strip.
  template <bool statistics, class Fill>
  void walk(const TargetFor<mode>& target, const RasterVertex& v0, const RasterVertex& v1, const RasterVertex& v2,
            bool narrow, const Fill& fill) const {
    using Cell = typename DepthRule<mode>::Cell;
    const auto fill_row = [&](std::int32_t row, std::int32_t left, std::int32_t right, std::int32_t whole_left,
                              std::int32_t whole_right) {
      const Span<Cell> span{target.template depth_row<Cell>(row) + (left - target.area.left),
                            target.colour_row(row) + (left - target.area.left),
                            right - left,
                            left - anchor_x,
                            row - anchor_y,
                            left - whole_left,
                            whole_right - whole_left};
      if constexpr (statistics) target.statistics->fragments += static_cast<std::uint32_t>(right - left);
      depth.for_each_run(span, fill);
    };
    if (narrow) {
      walk_spans<std::int32_t>(target, v0, v1, v2, fill_row);
    } else {
      walk_spans<std::int64_t>(target, v0, v1, v2, fill_row);
    }
  }

  std::int64_t area;
  std::int32_t anchor_x, anchor_y;  ///< a pixel of the picture near the triangle, whatever the strip
  PlaneSetup setup;
  TriangleDepth<mode.format> depth;
  DepthRule<mode> rule;
};

/// Draws a counter-clockwise triangle. `narrow`: all coordinates within kNarrowLimit; only speed depends on it.
/// `perspective`: that of zstrip::perspective_run().
template <Shade shade, bool orthographic, bool statistics, DepthMode mode = DepthMode{}, std::int32_t perspective = 16>
void draw_span_triangle(const TargetFor<mode>& target, const RasterVertex& v0, const RasterVertex& v1,
                        const RasterVertex& v2, const Surface& surface, bool narrow) {
  const SpanTriangle<mode> triangle(target, v0, v1, v2);
  const auto plane = [&](auto member) {
    const auto value = [&](const RasterVertex& v) { return std::int64_t{v.*member}; };
    return triangle.setup.plane(value(v0), value(v1) - value(v0), value(v2) - value(v0));
  };
  ColourPlanes colours{};
  constexpr bool kVaries = shade == Shade::gouraud || shade == Shade::textured_gouraud;
  if constexpr (kVaries) {
    colours = {plane(&RasterVertex::r), plane(&RasterVertex::g), plane(&RasterVertex::b)};
  } else if constexpr (shade == Shade::textured_flat) {
    const auto constant = [](std::int32_t value) { return Plane{static_cast<std::uint32_t>(value), 0, 0}; };
    colours = {constant(v0.r), constant(v0.g), constant(v0.b)};
  }

  using Cell = typename DepthRule<mode>::Cell;
  const DepthRule<mode>& rule = triangle.rule;
  const auto walk = [&](const auto& fill) { triangle.template walk<statistics>(target, v0, v1, v2, narrow, fill); };
  if constexpr (shade == Shade::flat) {
    walk([&](const Span<Cell>& run, const auto& z) {
      fill_flat<statistics>(run, z, rule, surface.flat_colour, target.statistics);
    });
  } else if constexpr (shade == Shade::gouraud) {
    walk([&](const Span<Cell>& run, const auto& z) {
      fill_gouraud<statistics>(run, z, rule, colours, target.statistics);
    });
  } else {
    const RasterVertex* const vertices[3] = {&v0, &v1, &v2};
    constexpr bool kAffine = orthographic || perspective == 0;
    constexpr int kLog2Run = perspective == 0 ? 4 : std::countr_zero(static_cast<std::uint32_t>(perspective));
    const TextureCoordinates<kAffine> coordinates(triangle.setup, vertices, surface.depth_offset);
    constexpr bool kLit = shade != Shade::textured;
    walk([&](const Span<Cell>& run, const auto& z) {
      fill_textured<kAffine, kLog2Run, kLit, statistics>(run, z, rule, surface.texture, coordinates, colours,
                                                         target.statistics);
    });
  }
}

}  // namespace zstrip::detail
