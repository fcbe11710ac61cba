// Draws small triangles in C++, on every processor: scans the box around the triangle with all three edge functions in
// one word. It draws the same pixels as the span rasteriser, with a fraction of its set-up.
#pragma once

#include <cstdint>

#include "zstrip/base/math.hpp"
#include "zstrip/geometry/project.hpp"
#include "zstrip/pixels/depth_rule.hpp"
#include "zstrip/pixels/small_scan.hpp"
#include "zstrip/pixels/target.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/view.hpp"

namespace zstrip::detail {

/// The edge functions 2 -> 0 and 0 -> 1 over the triangle: the weights of vertices 1 and 2, times the area. Exact,
/// without the fill rule. They grow by dy to the right and by -dx downwards.
struct SmallWeights {
  std::int32_t at_anchor[2];
  std::int32_t right[2], down[2];  ///< step a sub-pixel
};

/// Returns the depth plane. `from_0` are the differences to vertices 1 and 2, 14.16, below 2^29; `inverse_area` is 2^31
/// / area.
inline SmallPlane small_depth(const SmallWeights& weights, std::int32_t inverse_area, std::uint32_t depth_0,
                              std::int32_t from_0_to_1, std::int32_t from_0_to_2) {
  // The value per unit of an edge function, 16.16, rounded. A pixel's value is exactly depth_0 + k1 e1 + k2 e2.
  const auto per_unit = [inverse_area](std::int32_t difference) {
    return static_cast<std::uint32_t>(multiply_high_rounded(difference * 2, inverse_area));
  };
  const std::uint32_t k1 = per_unit(from_0_to_1);
  const std::uint32_t k2 = per_unit(from_0_to_2);
  const auto along = [k1, k2](const std::int32_t(&e)[2]) {
    return k1 * static_cast<std::uint32_t>(e[0]) + k2 * static_cast<std::uint32_t>(e[1]);
  };
  return {depth_0 + along(weights.at_anchor), along(weights.right) << 4, along(weights.down) << 4};
}

/// Planes of colour channels in 8.8. Start and steps are rounded down; a small triangle's error is below 1/8 unit.
class SmallChannels {
 public:
  SmallChannels(const SmallWeights& weights, std::int32_t inverse_area) : inverse_area_(inverse_area) {
    // A channel's numerator is below 2 * 255 * 8100: times 2^9 it fits 32 bits.
    for (int i = 0; i < 2; ++i) {
      at_anchor_[i] = weights.at_anchor[i] * (1 << 9);
      right_[i] = weights.right[i] * (1 << 13);
      down_[i] = weights.down[i] * (1 << 13);
    }
  }
  SmallPlane plane(std::int32_t c0, std::int32_t c1, std::int32_t c2) const {
    const std::int32_t d1 = c1 - c0;
    const std::int32_t d2 = c2 - c0;
    const auto along = [&](const std::int32_t(&e)[2]) {
      return static_cast<std::uint32_t>(multiply_high(d1 * e[0] + d2 * e[1], inverse_area_));
    };
    return {static_cast<std::uint32_t>(c0 * 256 + 128) + along(at_anchor_), along(right_), along(down_)};
  }

 private:
  std::int32_t inverse_area_;
  std::int32_t at_anchor_[2], right_[2], down_[2];
};

/// Sets up the planes from the area, anchor and colours of the scan. Calls `settle` after each stage.
template <bool gouraud>
[[gnu::always_inline]] inline void set_up_small_portable(SmallScan& scan, const SnappedVertex& v0,
                                                         const SnappedVertex& v1, const SnappedVertex& v2,
                                                         const Colour* const (&colours)[3]) {
  const std::int32_t x = scan.anchor_x * 16 + kPixelCentre - v0.x;
  const std::int32_t y = scan.anchor_y * 16 + kPixelCentre - v0.y;
  SmallWeights weights{{}, {v0.y - v2.y, v1.y - v0.y}, {v2.x - v0.x, v0.x - v1.x}};
  for (int i = 0; i < 2; ++i) weights.at_anchor[i] = x * weights.right[i] + y * weights.down[i];
  const std::int32_t right_0 = -weights.right[0] - weights.right[1];
  const std::int32_t down_0 = -weights.down[0] - weights.down[1];
  scan.set(
      SmallScan::edges,
      {PackedEdges::pack(PackedEdges::field(scan.area - weights.at_anchor[0] - weights.at_anchor[1], right_0, down_0),
                         PackedEdges::field(weights.at_anchor[0], weights.right[0], weights.down[0]),
                         PackedEdges::field(weights.at_anchor[1], weights.right[1], weights.down[1])),
       PackedEdges::pack(right_0, weights.right[0], weights.right[1]),
       PackedEdges::pack(down_0, weights.down[0], weights.down[1])});
  scan.settle();

  const std::int32_t inverse_area =
      of_any_sign(static_cast<std::int32_t>(quotient_31(static_cast<std::uint32_t>(scan.area))));
  scan.set(SmallScan::depth,
           small_depth(weights, inverse_area, v0.depth, static_cast<std::int32_t>(v1.depth - v0.depth),
                       static_cast<std::int32_t>(v2.depth - v0.depth)));
  scan.settle();
  if constexpr (gouraud) {
    const SmallChannels channels(weights, inverse_area);
    scan.set(SmallScan::green, channels.plane(colours[0]->g, colours[1]->g, colours[2]->g));
    scan.settle();
    const SmallPlane r = channels.plane(colours[0]->r, colours[1]->r, colours[2]->r);
    scan.set(SmallScan::red_blue, {r.start << 16, r.step_x << 16, r.step_y << 16});
    scan.settle();
    const SmallPlane b = channels.plane(colours[0]->b, colours[1]->b, colours[2]->b);
    scan.start[SmallScan::red_blue] += b.start;
    scan.step_x[SmallScan::red_blue] += b.step_x;
    scan.step_y[SmallScan::red_blue] += b.step_y;
  }
}

template <bool gouraud, bool statistics, class Rule>
[[gnu::noinline]] void scan_small_portable(SmallScan& scan, const Rule& rule) {
  for (std::uint32_t row = 0; row != static_cast<std::uint32_t>(scan.height); ++row) {
    scan.settle();
    const std::uint32_t edges_x = scan.step_x[SmallScan::edges];
    const std::int32_t width = scan.width;
    PackedEdges edges{scan.at(SmallScan::edges, 0, row)};
    std::int32_t i = 0;
    while (!edges.inside()) {
      edges.word += edges_x;
      if (++i == width) break;
    }
    if (i == width) continue;
    const auto column = static_cast<std::uint32_t>(i);
    std::uint32_t z = scan.at(SmallScan::depth, column, row);
    std::uint32_t red_blue = 0, green = 0;
    if constexpr (gouraud) {
      red_blue = scan.at(SmallScan::red_blue, column, row);
      green = scan.at(SmallScan::green, column, row);
    }
    std::uint16_t* const depth_row = scan.depth_row + static_cast<std::int32_t>(row) * scan.depth_stride;
    std::uint16_t* const colour_row = scan.colour_row + static_cast<std::int32_t>(row) * scan.colour_stride;
    do {
      if constexpr (statistics) ++scan.statistics->fragments;
      if (rule.draws(z, depth_row[i])) {
        if constexpr (gouraud) {
          colour_row[i] = static_cast<std::uint16_t>(((red_blue >> 16) & 0xF800U) | ((red_blue >> 11) & 0x1FU) |
                                                     ((green >> 5) & 0x7E0U));
        } else {
          colour_row[i] = scan.flat_colour;
        }
        if constexpr (statistics) ++scan.statistics->depth_passes;
      }
      z += scan.step_x[SmallScan::depth];
      red_blue += scan.step_x[SmallScan::red_blue];
      green += scan.step_x[SmallScan::green];
      edges.word += edges_x;
    } while (++i != width && edges.inside());
  }
}

struct PortableSmallStages {
  template <bool gouraud, bool statistics>
  [[gnu::always_inline]] static void set_up(SmallScan& scan, const SnappedVertex& v0, const SnappedVertex& v1,
                                            const SnappedVertex& v2, const Colour* const (&colours)[3]) {
    scan.settle();
    set_up_small_portable<gouraud>(scan, v0, v1, v2, colours);
  }
  template <bool gouraud, bool statistics, class Rule>
  [[gnu::always_inline]] static void draw(SmallScan& scan, const Rule& rule) {
    scan_small_portable<gouraud, statistics>(scan, rule);
  }
};

/// Draws a small triangle with the arguments of draw_small_triangle, and with set-up and scan of `Stages`.
template <bool gouraud, bool statistics, class Stages, class Rule>
void draw_small_by_scan(const StripTarget& target, const SnappedVertex& v0, const SnappedVertex& v1,
                        const SnappedVertex& v2, const Colour* const (&colours)[3], std::uint16_t flat_colour,
                        std::int32_t area, std::int32_t anchor_x, std::int32_t anchor_y, const Rect& box, Rule rule) {
  SmallScan scan;
  scan.first_column = static_cast<std::uint32_t>(box.left - anchor_x);
  scan.first_row = static_cast<std::uint32_t>(box.top - anchor_y);
  scan.width = box.width();
  scan.height = box.height();
  scan.depth_row = target.depth_row(box.top) + (box.left - target.area.left);
  scan.colour_row = target.colour_row(box.top) + (box.left - target.area.left);
  scan.depth_stride = target.depth_stride;
  scan.colour_stride = target.colour_stride;
  scan.area = area;
  scan.anchor_x = anchor_x;
  scan.anchor_y = anchor_y;
  if constexpr (!gouraud) scan.flat_colour = flat_colour;
  Stages::template set_up<gouraud, statistics>(scan, v0, v1, v2, colours);

  if ((scan.first_column | scan.first_row) != 0) {  // the strip or the picture cuts the box
    const auto skip_to_box = [&scan](SmallScan::Value value) {
      scan.start[value] = scan.at(value, scan.first_column, scan.first_row);
    };
    skip_to_box(SmallScan::edges);
    skip_to_box(SmallScan::depth);
    if constexpr (gouraud) {
      skip_to_box(SmallScan::green);
      skip_to_box(SmallScan::red_blue);
    }
  }
  if constexpr (statistics) scan.statistics = target.statistics;
  Stages::template draw<gouraud, statistics>(scan, rule);
}

template <bool gouraud, bool statistics, class Rule = DepthRule<DepthMode{}>>
void draw_small_triangle_portable(const StripTarget& target, const SnappedVertex& v0, const SnappedVertex& v1,
                                  const SnappedVertex& v2, const Colour* const (&colours)[3], std::uint16_t flat_colour,
                                  std::int32_t area, std::int32_t anchor_x, std::int32_t anchor_y, const Rect& box,
                                  Rule rule = {}) {
  draw_small_by_scan<gouraud, statistics, PortableSmallStages>(target, v0, v1, v2, colours, flat_colour, area, anchor_x,
                                                               anchor_y, box, rule);
}

}  // namespace zstrip::detail
