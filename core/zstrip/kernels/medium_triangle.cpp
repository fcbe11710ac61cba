// Draws a medium triangle: its planes, its rows down to the middle vertex, then the other rows.
#include "zstrip/kernels/medium_triangle.hpp"

#include <algorithm>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "zstrip/kernels/portable/medium_triangle.hpp"
#include "zstrip/kernels/portable/triangle_rows.hpp"

namespace zstrip::detail {
namespace {

template <bool gouraud>
void scan_rows(MediumScan& scan, std::int32_t count) {
  if constexpr (kHasThumb && gouraud) {
    scan_medium_gouraud_thumb(scan, count);
  } else if constexpr (kHasThumb) {
    scan_medium_flat_thumb(scan, count);
  } else {
    scan_medium_rows<gouraud>(scan, count);
  }
}

template <bool gouraud>
void prepare(MediumScan& scan, const MediumTriangle& t, const TriangleRows& rows,
             [[maybe_unused]] const Colour* const* colours, [[maybe_unused]] std::uint16_t flat_colour) {
  scan.area = t.area, scan.anchor_x = rows.anchor_x, scan.anchor_y = rows.anchor_y;
  scan.has_channels = gouraud;
  if constexpr (gouraud) {
    scan.set_colours(colours);
  } else {
    scan.flat_colour = flat_colour;
  }
}

/// Moves the start of each value down to the row `to`, from the row `from`.
template <bool gouraud>
void move_starts(MediumScan& scan, std::int32_t from, std::int32_t to) {
  for (int i = 0; i < (gouraud ? 4 : 1); ++i) {
    scan.start[i] += scan.step_y[i] * static_cast<std::uint32_t>(to - from);
  }
}

/// The rows of a triangle that crosses the left or the right side of the strip.
struct CutRows {
  std::int32_t first, last;    ///< columns of the strip, from the anchor's: the first, and the one after the last
  std::int32_t row_of_starts;  ///< the row to which the values' starts belong, once there are planes
  bool has_planes = false;
};

/// Draws the columns of the strip in rows from `row` to `end`. Planes are set up at the first row that has pixels
/// there: most triangles at the sides of a narrow strip have none. Returns false, without a pixel, if they cannot be.
template <bool gouraud>
[[gnu::noinline]] bool scan_cut_rows(MediumScan& scan, const MediumTriangle& t, CutRows& cut, std::int32_t row,
                                     std::int32_t end) {
  EdgeWalk &left = scan.rows.left, &right = scan.rows.right;
  for (; row < end; ++row) {
    const std::int32_t whole_left = left.pixel, whole_right = right.pixel;
    const std::int32_t cut_left = std::max(whole_left, cut.first), cut_right = std::min(whole_right, cut.last);
    if (cut_left >= cut_right) {
      scan.rows.go_down();
      continue;
    }
    if (!cut.has_planes && !set_up_medium(scan, t.v0, t.v1, t.v2)) return false;
    cut.has_planes = true;
    if (cut.row_of_starts != row) move_starts<gouraud>(scan, cut.row_of_starts, row);
    cut.row_of_starts = row + 1;
    left.pixel = cut_left, right.pixel = cut_right;
    scan_rows<gouraud>(scan, 1);
    left.pixel += whole_left - cut_left, right.pixel += whole_right - cut_right;
  }
  return true;
}

template <bool gouraud>
bool draw_cut(const MediumTriangle& t, const Colour* const* colours, std::uint16_t flat_colour) {
  TriangleRows rows;
  rows.bound(t);
  if (!fits_words(t, rows.width, rows.height)) return false;
  rows.anchor_x = std::max(rows.anchor_x, t.target.view_left);
  if (!rows.find_rows(t)) return true;

  MediumScan scan;
  prepare<gouraud>(scan, t, rows, colours, flat_colour);
  const Rect& strip = t.target.area;
  CutRows cut{strip.left - rows.anchor_x, strip.right - rows.anchor_x, rows.anchor_y};
  if (rows.begin_first(scan.rows, t)) {
    if (!scan_cut_rows<gouraud>(scan, t, cut, rows.row, rows.middle)) return false;
    if (rows.middle == rows.end) return true;
    rows.row = rows.middle;
  }
  rows.begin_second(scan.rows, t);
  return scan_cut_rows<gouraud>(scan, t, cut, rows.row, rows.end);
}

/// `t` is a copy, so that its references can stay in registers.
template <bool gouraud>
bool draw(const MediumTriangle t, const Colour* const* colours, std::uint16_t flat_colour) {
  TriangleRows rows;
  rows.bound(t);
  if (!fits_words(t, rows.width, rows.height) || !rows.lies_in(t.target.area)) return false;
  if (!rows.find_rows(t)) return true;

  MediumScan scan;
  prepare<gouraud>(scan, t, rows, colours, flat_colour);
  if (!set_up_medium(scan, t.v0, t.v1, t.v2)) return false;
  if (rows.row != rows.anchor_y) move_starts<gouraud>(scan, rows.anchor_y, rows.row);
  if (rows.begin_first(scan.rows, t)) {
    scan_rows<gouraud>(scan, rows.middle - rows.row);
    if (rows.middle == rows.end) return true;
    rows.row = rows.middle;
  }
  rows.begin_second(scan.rows, t);
  scan_rows<gouraud>(scan, rows.end - rows.row);
  return true;
}

}  // namespace

void set_medium_edge(EdgeWalk& edge, const SnappedVertex& from, const SnappedVertex& to, std::int32_t row,
                     std::int32_t anchor_x) {
  edge = EdgeWalk(from.x, from.y, to.x, to.y, row, std::true_type{});
  edge.pixel -= anchor_x;
  edge.remainder -= edge.denominator;
}

bool draw_medium_gouraud_by_rows(const MediumTriangle& triangle, const Colour* const (&colours)[3]) {
  return draw<true>(triangle, colours, 0);
}

bool draw_medium_flat_by_rows(const MediumTriangle& triangle, std::uint16_t colour) {
  return draw<false>(triangle, nullptr, colour);
}

bool draw_cut_gouraud_by_rows(const MediumTriangle& triangle, const Colour* const (&colours)[3]) {
  return draw_cut<true>(triangle, colours, 0);
}

bool draw_cut_flat_by_rows(const MediumTriangle& triangle, std::uint16_t colour) {
  return draw_cut<false>(triangle, nullptr, colour);
}

}  // namespace zstrip::detail
