// Draws triangles of any size row by row: exact edges, one span a row.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <tuple>
#include <type_traits>
#include <utility>

#include "zstrip/kernels/span.hpp"
#include "zstrip/kernels/textured_span.hpp"
#include "zstrip/pixels/edge_walk.hpp"
#include "zstrip/pixels/plane.hpp"
#include "zstrip/raster/method_hooks.hpp"
#include "zstrip/visibility/traits.hpp"

namespace zstrip::detail {

/// Sorts three vertices by row, the uppermost first.
[[gnu::always_inline]] inline void sort_by_row(const RasterVertex*& top, const RasterVertex*& middle,
                                               const RasterVertex*& bottom) {
  if (middle->y < top->y) std::swap(middle, top);
  if (bottom->y < middle->y) std::swap(bottom, middle);
  if (middle->y < top->y) std::swap(middle, top);
}

template <class Narrow, class FillSpan>
void walk_spans(const StripTarget& target, const RasterVertex& a, const RasterVertex& b, const RasterVertex& c,
                Narrow narrow, const FillSpan& fill) {
  const RasterVertex* top = &a;
  const RasterVertex* middle = &b;
  const RasterVertex* bottom = &c;
  sort_by_row(top, middle, bottom);

  const std::int32_t end = std::min(bottom->y >> 4, target.area.bottom);
  std::int32_t row = std::max(top->y >> 4, target.area.top);
  if (row >= end) return;
  // The middle vertex is right of the long edge if the area of top, bottom, middle is positive (y down).
  const bool middle_is_right = signed_area(*top, *middle, *bottom) < 0;
  EdgeWalk long_edge(top->x, top->y, bottom->x, bottom->y, row, narrow);
  for (int half = 0; half < 2; ++half) {
    const RasterVertex& from = half == 0 ? *top : *middle;
    const RasterVertex& to = half == 0 ? *middle : *bottom;
    const std::int32_t half_end = std::min(to.y >> 4, end);
    if (row >= half_end) continue;
    EdgeWalk short_edge(from.x, from.y, to.x, to.y, row, narrow);
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

/// The spans of a whole triangle in the rows of one of its parts, from top to bottom.
template <class Narrow>
class WholeSpans {
 public:
  WholeSpans(const RasterVertex& a, const RasterVertex& b, const RasterVertex& c, Narrow narrow)
      : sorted_{&a, &b, &c}, narrow_(narrow) {
    sort_by_row(sorted_[0], sorted_[1], sorted_[2]);
    middle_is_right_ = signed_area(*sorted_[0], *sorted_[1], *sorted_[2]) < 0;
  }

  /// Returns the first pixel and the one after the last, in a row that the triangle covers. Rows must not go up from
  /// one call to the next.
  std::pair<std::int32_t, std::int32_t> at(std::int32_t row) {
    const std::int32_t half = row < sorted_[1]->y >> 4 ? 0 : 1;
    if (half != half_) {
      if (half_ < 0) long_ = walk(0, 2, row), row_ = row;
      short_ = walk(half, half + 1, row);
      half_ = half;
      for (; row_ < row; ++row_) long_.next_row();
    }
    for (; row_ < row; ++row_) long_.next_row(), short_.next_row();
    return middle_is_right_ ? std::pair(long_.pixel, short_.pixel) : std::pair(short_.pixel, long_.pixel);
  }

 private:
  EdgeWalk walk(std::int32_t from, std::int32_t to, std::int32_t row) const {
    const RasterVertex &a = *sorted_[from], &b = *sorted_[to];
    return EdgeWalk(a.x, a.y, b.x, b.y, row, narrow_);
  }

  const RasterVertex* sorted_[3];
  bool middle_is_right_;
  std::int32_t half_ = -1, row_ = 0;
  EdgeWalk long_, short_;
  [[no_unique_address]] Narrow narrow_;
};

/// A triangle after set-up: its anchor, its depth, and its spans in a strip. `Planes` sets up its planes.
template <DepthMode mode, class Planes = PlaneSetup>
struct SpanTriangle {
  // A call would pass all members through memory.
  [[gnu::always_inline]] SpanTriangle(const TargetFor<mode>& target, const RasterVertex& v0, const RasterVertex& v1,
                                      const RasterVertex& v2)
      : area(signed_area(v0, v1, v2)),
        anchor_x(std::max(std::min({v0.x, v1.x, v2.x}) >> 4, target.view_left)),
        anchor_y(std::max(std::min({v0.y, v1.y, v2.y}) >> 4, target.view_top)),
        setup(v0, v1, v2, area, anchor_x, anchor_y),
        depth(setup, v0, v1, v2),
        rule(target, v0, v1, v2, area) {}

  /// Calls fill(run, depth plane, rule) for all runs in the strip that may be visible. If the triangle is split into
  /// parts, a part only selects pixels and their rule: all planes are those of the whole triangle. `in_runs`: fill
  /// counts pixels from the left end of the whole span.
  template <bool statistics, bool in_runs, class Narrow, class Fill>
  void walk(const TargetFor<mode>& target, const RasterVertex& v0, const RasterVertex& v1, const RasterVertex& v2,
            Narrow narrow, const Fill& fill) const {
    if constexpr (methods::splits(mode.method())) {
      const DepthRule<mode.with(DepthUse::written)> writing(target, v0, v1, v2, area);
      methods::for_each_piece<mode>(target, v0, v1, v2, [&](const RasterVertex(&part)[3], DepthUse use) {
        const auto walk_piece = [&](const auto& whole, const auto& how) {
          walk_part<statistics>(target, part[0], part[1], part[2], narrow, how, whole, fill);
        };
        const auto walk_with = [&](const auto& whole) {
          use == DepthUse::tested ? walk_piece(whole, rule) : walk_piece(whole, writing);
        };
        if constexpr (!in_runs) {
          walk_with(Unsplit{});
        } else {
          walk_with(WholeSpans(v0, v1, v2, narrow));
        }
      });
    } else {
      walk_part<statistics>(target, v0, v1, v2, narrow, rule, Unsplit{}, fill);
    }
  }

  struct Unsplit {};  ///< takes the place of WholeSpans if the part is the whole triangle, or WholeSpans is not used

  template <bool statistics, class Narrow, class Rule, class Whole, class Fill>
  void walk_part(const TargetFor<mode>& target, const RasterVertex& a, const RasterVertex& b, const RasterVertex& c,
                 Narrow narrow, const Rule& how, [[maybe_unused]] Whole whole, const Fill& fill) const {
    using Cell = typename Rule::Cell;
    const auto fill_run = [&](const Span<Cell>& run, const auto& plane) { fill(run, plane, how); };
    const auto fill_row = [&](std::int32_t row, std::int32_t left, std::int32_t right, std::int32_t whole_left,
                              std::int32_t whole_right) {
      if constexpr (!std::is_same_v<Whole, Unsplit>) std::tie(whole_left, whole_right) = whole.at(row);
      const Span<Cell> span{target.template depth_row<Cell>(row) + (left - target.area.left),
                            target.colour_row(row) + (left - target.area.left),
                            right - left,
                            left - anchor_x,
                            row - anchor_y,
                            left - whole_left,
                            whole_right - whole_left};
      if constexpr (statistics) target.statistics->fragments += static_cast<std::uint32_t>(right - left);
      if constexpr (methods::hides_by_bounds(mode.method())) {
        methods::for_each_shown_run<mode>(target, depth, row, left, span,
                                          [&](const Span<Cell>& run) { fill_run(run, depth.plane()); });
      } else {
        depth.for_each_run(span, fill_run);
      }
    };
    walk_spans(target, a, b, c, narrow, fill_row);
  }

  std::int64_t area;
  std::int32_t anchor_x, anchor_y;  ///< a pixel of the picture near the triangle; does not depend on the strip
  Planes setup;
  TriangleDepth<mode.format> depth;
  DepthRule<mode> rule;
};

/// Draws a counter-clockwise triangle. `narrow`: all coordinates are within kNarrowLimit; a bool or std::true_type.
/// Only the speed depends on it. `perspective`: the result of zstrip::perspective_run().
template <Shade shade, bool orthographic, bool statistics, DepthMode mode = DepthMode{}, std::int32_t perspective = 16,
          class Planes = PlaneSetup, class Narrow = bool>
void draw_span_triangle(const TargetFor<mode>& target, const RasterVertex& v0, const RasterVertex& v1,
                        const RasterVertex& v2, const Surface& surface, Narrow narrow) {
  const SpanTriangle<mode, Planes> triangle(target, v0, v1, v2);
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
  const auto walk = [&](const auto& fill) {
    triangle.template walk<statistics, (shade >= Shade::textured)>(target, v0, v1, v2, narrow, fill);
  };
  if constexpr (shade == Shade::flat) {
    walk([&](const Span<Cell>& run, const auto& z, const auto& how) {
      fill_flat<statistics>(run, z, how, surface.flat_colour, target.statistics);
    });
  } else if constexpr (shade == Shade::gouraud) {
    walk([&](const Span<Cell>& run, const auto& z, const auto& how) {
      fill_gouraud<statistics>(run, z, how, colours, target.statistics);
    });
  } else {
    const RasterVertex* const vertices[3] = {&v0, &v1, &v2};
    constexpr bool kAffine = orthographic || perspective == 0;
    constexpr int kLog2Run = perspective == 0 ? 4 : std::countr_zero(static_cast<std::uint32_t>(perspective));
    const TextureCoordinates<kAffine> coordinates(triangle.setup, vertices, surface.depth_offset);
    constexpr TexelLight kLit = shade == Shade::textured        ? TexelLight::none
                                : shade == Shade::textured_flat ? TexelLight::flat
                                                                : TexelLight::smooth;
    walk([&](const Span<Cell>& run, const auto& z, const auto& how) {
      fill_textured<kAffine, kLog2Run, kLit, statistics>(run, z, how, surface.texture, coordinates, colours,
                                                         target.statistics);
    });
  }
}

}  // namespace zstrip::detail
