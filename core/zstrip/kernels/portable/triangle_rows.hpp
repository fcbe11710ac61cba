// The rows of a medium triangle in a strip, and the edges that bound them.
#pragma once

#include <algorithm>
#include <cstdint>

#include "zstrip/kernels/portable/medium_triangle.hpp"
#include "zstrip/pixels/medium_scan.hpp"
#include "zstrip/pixels/target.hpp"

namespace zstrip::detail {

/// The rows in two parts: down to the middle vertex, and below it. The first part may be empty.
struct TriangleRows {
  std::int32_t anchor_x, anchor_y;
  std::int32_t right;          ///< the column after the last one
  std::int32_t width, height;  ///< size of the triangle, 12.4
  std::int32_t row;
  std::int32_t middle, end;  ///< the first row of the second part; the row after the last one
  bool middle_is_left;

  /// Sets all members except the rows.
  void bound(const MediumTriangle& t) {
    const SnappedVertex &a = t.v0, &b = t.v1, &c = t.v2;
    // Single words: GCC would put an array into memory on a Cortex-M0.
    const std::int32_t x0 = a.x, x1 = b.x, x2 = c.x;
    const std::int32_t min_x = std::min(std::min(x0, x1), x2), max_x = std::max(std::max(x0, x1), x2);
    // The first vertex is the highest; seen from it, the second one lies on the left.
    middle_is_left = b.y < c.y;
    width = max_x - min_x, height = (middle_is_left ? c.y : b.y) - a.y;
    anchor_x = min_x >> 4, anchor_y = std::max<std::int32_t>(a.y >> 4, t.target.view_top);
    right = max_x >> 4;
  }

  /// True if the triangle crosses neither the left nor the right side of the strip.
  bool lies_in(const Rect& strip) const { return anchor_x >= strip.left && right <= strip.right; }

  bool find_rows(const MediumTriangle& t) {
    const Rect& strip = t.target.area;
    row = std::max<std::int32_t>(t.v0.y >> 4, strip.top);
    end = std::min<std::int32_t>((t.v0.y + height) >> 4, strip.bottom);
    if (row >= end) return false;
    middle = std::min<std::int32_t>((middle_is_left ? t.v1.y : t.v2.y) >> 4, end);
    return true;
  }

  /// Sets rows and edges for the first part, and returns true if it has rows; otherwise sets only the edge that the
  /// second part keeps.
  bool begin_first(MediumRows& edges, const MediumTriangle& t) const {
    edges.set_target(t.target, row, anchor_x);
    const bool has_first = row < middle;
    if (has_first || !middle_is_left) set_medium_edge(edges.left, t.v0, t.v1, row, anchor_x);
    if (has_first || middle_is_left) set_medium_edge(edges.right, t.v0, t.v2, row, anchor_x);
    return has_first;
  }
  /// Replaces the edge that ended at the middle vertex.
  void begin_second(MediumRows& edges, const MediumTriangle& t) const {
    if (middle_is_left) {
      set_medium_edge(edges.left, t.v1, t.v2, row, anchor_x);
    } else {
      set_medium_edge(edges.right, t.v2, t.v1, row, anchor_x);
    }
  }
};

}  // namespace zstrip::detail
