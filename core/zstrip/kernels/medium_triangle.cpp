// Draws a medium triangle: its planes, its rows down to the middle vertex, then the other rows.
#include "zstrip/kernels/portable/medium_triangle.hpp"

#include <cstdint>
#include <type_traits>
#include <utility>

#include "zstrip/kernels/medium_triangle.hpp"
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

/// `t` is a copy, so that its references can stay in registers.
template <bool gouraud>
bool draw(const MediumTriangle t, [[maybe_unused]] const Colour* const* colours,
          [[maybe_unused]] std::uint16_t flat_colour) {
  TriangleRows rows;
  rows.bound(t);
  if (!fits_words(t, rows.width, rows.height) || !rows.lies_in(t.target.area)) return false;
  if (!rows.find_rows(t)) return true;

  MediumScan scan;
  scan.area = t.area, scan.anchor_x = rows.anchor_x, scan.anchor_y = rows.anchor_y;
  scan.has_channels = gouraud;
  if constexpr (gouraud) {
    scan.set_colours(colours);
  } else {
    scan.flat_colour = flat_colour;
  }
  if (!set_up_medium(scan, t.v0, t.v1, t.v2)) return false;
  if (rows.row != rows.anchor_y) {
    for (int i = 0; i < (gouraud ? 4 : 1); ++i) {
      scan.start[i] += scan.step_y[i] * static_cast<std::uint32_t>(rows.row - rows.anchor_y);
    }
  }
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

bool draw_medium_gouraud_portable(const MediumTriangle& triangle, const Colour* const (&colours)[3]) {
  return draw<true>(triangle, colours, 0);
}

bool draw_medium_flat_portable(const MediumTriangle& triangle, std::uint16_t colour) {
  return draw<false>(triangle, nullptr, colour);
}

}  // namespace zstrip::detail
