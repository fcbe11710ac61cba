// Kernel: draws triangles of a few pixels (see is_small), from narrow vertices to depth and colour.
//
// Vertices are 12.4 raster coordinates and 16.16 depth codes; colours are 8 bits a channel. Cells and pixels are the
// same as from the span rasteriser; every implementation writes the same bits as portable/small_triangle.hpp. Thumb-1
// supports interpolated colours, Thumb-2 and vectors all colours; only for the depth test of z16, without counting.
#pragma once

#include <cstdint>
#include <type_traits>

#include "zstrip/base/processor.hpp"
#include "zstrip/geometry/project.hpp"
#include "zstrip/kernels/portable/small_triangle.hpp"
#include "zstrip/kernels/thumb/small_triangle.hpp"
#include "zstrip/kernels/vector/small_triangle.hpp"
#include "zstrip/pixels/depth_rule.hpp"
#include "zstrip/pixels/small_scan.hpp"
#include "zstrip/pixels/target.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/view.hpp"

namespace zstrip::detail {

/// Sets up the planes of edges, depth (16.16) and, if `gouraud`, colours (8.8) from the scan's area and anchor: its
/// `start`, `step_x` and `step_y`. Colours are copied into the scan for the assembly.
template <bool gouraud, bool statistics>
[[gnu::always_inline]] inline void set_up_small(SmallScan& scan, const SnappedVertex& v0, const SnappedVertex& v1,
                                                const SnappedVertex& v2, const Colour* const (&colours)[3]) {
  if constexpr (kHasThumb && gouraud && !statistics) {
    for (int i = 0; i < 3; ++i) scan.set_colour(i, *colours[i]);
    set_up_small_thumb(scan, v0, v1, v2);
  } else {
    PortableSmallStages::set_up<gouraud, statistics>(scan, v0, v1, v2, colours);
  }
}

/// Draws the pixels of a scan after set-up. May change its starts and rows.
template <bool gouraud, bool statistics, class Rule>
[[gnu::always_inline]] inline void scan_small(SmallScan& scan, const Rule& rule) {
  constexpr bool kHasRule = !statistics && std::is_same_v<Rule, DepthRule<DepthMode{}>>;
  if constexpr (kHasThumb && gouraud && kHasRule) {
    scan_small_thumb(scan);
  } else if constexpr (kHasThumb && kHasRule) {
    scan_small_flat_thumb(scan);
  } else {
    PortableSmallStages::draw<gouraud, statistics>(scan, rule);
  }
}

struct SmallStages {
  template <bool gouraud, bool statistics>
  [[gnu::always_inline]] static void set_up(SmallScan& scan, const SnappedVertex& v0, const SnappedVertex& v1,
                                            const SnappedVertex& v2, const Colour* const (&colours)[3]) {
    set_up_small<gouraud, statistics>(scan, v0, v1, v2, colours);
  }
  template <bool gouraud, bool statistics, class Rule>
  [[gnu::always_inline]] static void draw(SmallScan& scan, const Rule& rule) {
    scan_small<gouraud, statistics>(scan, rule);
  }
};

/// Draws a small triangle. `area` is twice the signed area, > 0. `anchor_x`, `anchor_y`: the first pixel of the
/// triangle's whole box, where all values start, so that no rounding depends on the strip. `box`: the pixels to scan,
/// not empty, inside the target's area. `colours`: those of the three vertices if `gouraud`. Inlined, because a call
/// would pass all arguments through memory.
template <bool gouraud, bool statistics, class Rule = DepthRule<DepthMode{}>>
[[gnu::always_inline]] inline void draw_small_triangle(const StripTarget& target, const SnappedVertex& v0,
                                                       const SnappedVertex& v1, const SnappedVertex& v2,
                                                       const Colour* const (&colours)[3], std::uint16_t flat_colour,
                                                       std::int32_t area, std::int32_t anchor_x, std::int32_t anchor_y,
                                                       const Rect& box, Rule rule = {}) {
  if constexpr (kHasVectors && !statistics && Rule::kNearerOnly) {
    const SmallTriangle triangle{target, v0, v1, v2, area, anchor_x, anchor_y, box};
    if constexpr (gouraud) {
      if (draw_small_gouraud_vector(triangle, colours)) return;
    } else {
      if (draw_small_flat_vector(triangle, flat_colour)) return;
    }
  }
  draw_small_by_scan<gouraud, statistics, SmallStages>(target, v0, v1, v2, colours, flat_colour, area, anchor_x,
                                                       anchor_y, box, rule);
}

}  // namespace zstrip::detail
