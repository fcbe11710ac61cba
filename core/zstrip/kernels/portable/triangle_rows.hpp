// The rows of a medium triangle in a strip, and the edges between which they lie.
#pragma once

#include <algorithm>
#include <cstdint>

#include "zstrip/kernels/medium_scan.hpp"
#include "zstrip/kernels/portable/medium_triangle.hpp"
#include "zstrip/raster/target.hpp"

namespace zstrip::detail {

/// In two parts: down to the middle vertex, and from there on. The first one may have no rows.
struct TriangleRows {
  std::int32_t anchor_x, anchor_y;
  std::int32_t right;          ///< no column lies from here on
  std::int32_t width, height;  ///< of the triangle, 12.4
  std::int32_t row;            ///< the next one
  std::int32_t middle, end;    ///< row that the second part begins with; the one behind the last
  bool middle_is_left;

  /// All but the rows.
  void bound(const MediumTriangle& t) {
    const SnappedVertex &a = t.v0, &b = t.v1, &c = t.v2;
    // Words, no array: a Cortex-M0 would make one.
    const std::int32_t x0 = a.x, x1 = b.x, x2 = c.x;
    const std::int32_t min_x = std::min(std::min(x0, x1), x2), max_x = std::max(std::max(x0, x1), x2);
    // The first vertex is the highest; from it the second lies to the left.
    middle_is_left = b.y < c.y;
    width = max_x - min_x, height = (middle_is_left ? c.y : b.y) - a.y;
    anchor_x = min_x >> 4, anchor_y = std::max<std::int32_t>(a.y >> 4, t.target.view_top);
    right = max_x >> 4;
  }

  /// True if the triangle crosses neither side of the strip.
  bool lies_in(const Rect& strip) const { return anchor_x >= strip.left && right <= strip.right; }

  /// Returns true if there are rows.
  bool find_rows(const MediumTriangle& t) {
    const Rect& strip = t.target.area;
    row = std::max<std::int32_t>(t.v0.y >> 4, strip.top);
    end = std::min<std::int32_t>((t.v0.y + height) >> 4, strip.bottom);
    if (row >= end) return false;
    middle = std::min<std::int32_t>((middle_is_left ? t.v1.y : t.v2.y) >> 4, end);
    return true;
  }

  /// Returns true if the first part has rows. Sets rows and edges for it, or the values that the second part keeps.
  bool begin_first(MediumRows& edges, const MediumTriangle& t) const {
    edges.set_target(t.target, row, anchor_x);
    const bool has_first = row < middle;
    if (has_first || !middle_is_left) set_medium_edge(edges.left, t.v0, t.v1, row, anchor_x);
    if (has_first || middle_is_left) set_medium_edge(edges.right, t.v0, t.v2, row, anchor_x);
    return has_first;
  }
  /// The edge that ends the first part is followed by another.
  void begin_second(MediumRows& edges, const MediumTriangle& t) const {
    if (middle_is_left) {
      set_medium_edge(edges.left, t.v1, t.v2, row, anchor_x);
    } else {
      set_medium_edge(edges.right, t.v2, t.v1, row, anchor_x);
    }
  }
};

}  // namespace zstrip::detail
