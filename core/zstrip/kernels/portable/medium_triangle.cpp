// A medium triangle: its planes, then its rows down to the middle vertex, and from there on.
#include "zstrip/kernels/portable/medium_triangle.hpp"

#include <algorithm>
#include <cstdint>
#include <type_traits>
#include <utility>

#include "zstrip/kernels/medium_triangle.hpp"

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
bool draw(const MediumTriangle& t, [[maybe_unused]] const Colour* const* colours,
          [[maybe_unused]] std::uint16_t flat_colour) {
  const StripTarget& target = t.target;
  const SnappedVertex &a = t.v0, &b = t.v1, &c = t.v2;
  // Of whole words, not of an array: or a Cortex-M0 makes one.
  const std::int32_t x0 = a.x, x1 = b.x, x2 = c.x;
  const std::int32_t min_x = std::min(std::min(x0, x1), x2), max_x = std::max(std::max(x0, x1), x2);
  const bool middle_is_left = b.y < c.y;
  const std::int32_t bottom = middle_is_left ? c.y : b.y;
  const std::int32_t anchor_x = min_x >> 4, anchor_y = std::max<std::int32_t>(a.y >> 4, target.view_top);
  if (!fits_words(t, max_x - min_x, bottom - a.y) || anchor_x < target.area.left || max_x >> 4 > target.area.right) {
    return false;
  }
  std::int32_t row = std::max<std::int32_t>(a.y >> 4, target.area.top);
  const std::int32_t end = std::min<std::int32_t>(bottom >> 4, target.area.bottom);
  if (row >= end) return true;
  const std::int32_t middle = std::min<std::int32_t>((middle_is_left ? b.y : c.y) >> 4, end);

  MediumScan scan;
  scan.area = t.area, scan.anchor_x = anchor_x, scan.anchor_y = anchor_y;
  scan.has_channels = gouraud;
  if constexpr (gouraud) {
    scan.set_colours(colours);
  } else {
    scan.flat_colour = flat_colour;
  }
  if (!set_up_medium(scan, a, b, c)) return false;
  if (row != anchor_y) {
    for (int i = 0; i < (gouraud ? 4 : 1); ++i) {
      scan.start[i] += scan.step_y[i] * static_cast<std::uint32_t>(row - anchor_y);
    }
  }
  scan.rows.set_target(target, row, anchor_x);
  // The first vertex is the highest; from it the second lies to the left.
  const bool has_upper = row < middle;
  if (has_upper || !middle_is_left) set_medium_edge(scan.rows.left, a, b, row, anchor_x);
  if (has_upper || middle_is_left) set_medium_edge(scan.rows.right, a, c, row, anchor_x);
  if (has_upper) {
    scan_rows<gouraud>(scan, middle - row);
    if (middle == end) return true;
    row = middle;
  }
  if (middle_is_left) {
    set_medium_edge(scan.rows.left, b, c, row, anchor_x);
  } else {
    set_medium_edge(scan.rows.right, c, b, row, anchor_x);
  }
  scan_rows<gouraud>(scan, end - row);
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
