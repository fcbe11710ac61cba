// Triangles of a few pixels: the box around the triangle is scanned with all three edge functions in one word.
// The same pixels as the span rasteriser's, at a fraction of its set-up.
#pragma once

#include <cstdint>

#include "zstrip/base/math.hpp"
#include "zstrip/geometry/project.hpp"
#include "zstrip/raster/colour.hpp"
#include "zstrip/raster/depth_rule.hpp"
#include "zstrip/raster/target.hpp"

namespace zstrip::detail {

/// Width plus height of the bounding box, in 1/16 pixels, below which a triangle is small. Then
/// width * height <= 90 * 90 = 8100, so an edge function >> 4 is within -512..511.
inline constexpr std::int32_t kSmallExtent = 181;

/// Depth differences of small triangles stay below 8192 codes, so that 31-bit products keep the promised precision.
inline constexpr std::uint32_t kSmallDepthDifference = 1U << 29;  // 16.16

/// Three edge functions / 16 in fields of 10, 11 and 11 bits. Pixel steps are multiples of 16, so the division by 16
/// loses nothing that a sign could show. A field that goes negative borrows from the one above; while all are >= 0
/// there is no borrow, so "no sign bit set" is exact.
struct PackedEdges {
  std::uint32_t word;
  static constexpr std::uint32_t kSigns = (1U << 31) | (1U << 21) | (1U << 10);

  static constexpr std::uint32_t pack(std::int32_t a, std::int32_t b, std::int32_t c) {
    return (static_cast<std::uint32_t>(a) << 22) + (static_cast<std::uint32_t>(b) << 11) +
           static_cast<std::uint32_t>(c);
  }
  constexpr bool inside() const { return (word & kSigns) == 0; }
};

/// Edge function of a -> b at (x, y), positive inside. Left edges and horizontal top edges include their zero.
struct SmallEdge {
  std::int32_t dx, dy;
  std::int32_t at_anchor;  ///< exact, without the fill rule

  constexpr SmallEdge(const SnappedVertex& a, const SnappedVertex& b, std::int32_t x, std::int32_t y)
      : dx(b.x - a.x), dy(b.y - a.y), at_anchor((x - a.x) * dy - (y - a.y) * dx) {}
  /// Minus one unless top-left: dy > 0, or dy == 0 and dx < 0.
  constexpr std::int32_t with_fill_rule() const { return at_anchor + ((dy * 65536 - dx) >> 31); }
};

/// A value that is linear over the triangle: its start at the anchor pixel and its steps. Modulo 2^32: on slivers the
/// steps overflow and cancel.
struct SmallPlane {
  std::uint32_t start, step_x, step_y;
};

struct SmallSetup {
  std::int32_t inverse_area;  // 2^31 / area
  const SmallEdge& toward_1;  // the edge whose function is the weight of vertex 1
  const SmallEdge& toward_2;

  /// `from_0_to_1`, `from_0_to_2` in 14.16, below 2^29.
  SmallPlane plane(std::uint32_t value_0, std::int32_t from_0_to_1, std::int32_t from_0_to_2) const {
    // Value per unit of edge function, 16.16, rounded; every pixel's value is exactly value_0 + k1 e1 + k2 e2.
    const std::uint32_t k1 = per_unit(from_0_to_1);
    const std::uint32_t k2 = per_unit(from_0_to_2);
    const auto e = [](std::int32_t value) { return static_cast<std::uint32_t>(value); };
    return {value_0 + k1 * e(toward_1.at_anchor) + k2 * e(toward_2.at_anchor),
            (k1 * e(toward_1.dy) + k2 * e(toward_2.dy)) << 4, (k1 * e(-toward_1.dx) + k2 * e(-toward_2.dx)) << 4};
  }

  /// A colour channel in 8.8. Start and steps are rounded down: less than 1/8 unit over a small triangle.
  SmallPlane channel(std::int32_t c0, std::int32_t c1, std::int32_t c2) const {
    const std::int32_t d1 = c1 - c0;
    const std::int32_t d2 = c2 - c0;
    return {
        static_cast<std::uint32_t>(c0 * 256 + 128) + quotient_8_8(d1 * toward_1.at_anchor + d2 * toward_2.at_anchor),
        quotient_8_8((d1 * toward_1.dy + d2 * toward_2.dy) * 16),
        quotient_8_8((d1 * toward_1.dx + d2 * toward_2.dx) * -16)};
  }

 private:
  /// |numerator| <= 2 * 255 * 8100: times 512 it fits 32 bits.
  std::uint32_t quotient_8_8(std::int32_t numerator) const {
    return static_cast<std::uint32_t>(multiply_high(numerator * 512, inverse_area));
  }
  std::uint32_t per_unit(std::int32_t difference) const {
    const std::int64_t product = std::int64_t{difference * 2} * inverse_area;
    return static_cast<std::uint32_t>((product + (std::int64_t{1} << 31)) >> 32);
  }
};

/// Whether this triangle may be drawn by draw_small_triangle. Depends on the triangle alone, never on the strip.
inline bool is_small(std::int32_t width, std::int32_t height, const SnappedVertex& a, const SnappedVertex& b,
                     const SnappedVertex& c) {
  // Of halves, because differences of whole depths need 33 bits.
  const auto near_a = [&a](const SnappedVertex& v) {
    return (a.depth >> 1) - (v.depth >> 1) + kSmallDepthDifference / 2 < kSmallDepthDifference;
  };
  return width + height < kSmallExtent && near_a(b) && near_a(c);
}

/// `area` is twice the signed area, > 0; `anchor_x`, `anchor_y` the first pixel of the triangle's whole box: all values
/// start there, so that no rounding depends on the strip; `box` the pixels to scan, not empty, inside the target's
/// area. `colours` of the three vertices where `gouraud`, else the one at [0]. Depths are 16.16 codes.
template <bool gouraud, bool statistics, class Rule = DepthRule<DepthMode{}>>
void draw_small_triangle(const StripTarget& target, const SnappedVertex& v0, const SnappedVertex& v1,
                         const SnappedVertex& v2, const Colour* const (&colours)[3], std::uint16_t flat_colour,
                         std::int32_t area, std::int32_t anchor_x, std::int32_t anchor_y, const Rect& box,
                         Rule rule = {}) {
  const std::int32_t x = anchor_x * 16 + kPixelCentre;
  const std::int32_t y = anchor_y * 16 + kPixelCentre;
  const SmallEdge edge_12(v1, v2, x, y);
  const SmallEdge edge_20(v2, v0, x, y);
  const SmallEdge edge_01(v0, v1, x, y);
  PackedEdges row{
      PackedEdges::pack(edge_12.with_fill_rule() >> 4, edge_20.with_fill_rule() >> 4, edge_01.with_fill_rule() >> 4)};
  const std::uint32_t edges_x = PackedEdges::pack(edge_12.dy, edge_20.dy, edge_01.dy);
  const std::uint32_t edges_y = PackedEdges::pack(-edge_12.dx, -edge_20.dx, -edge_01.dx);

  const SmallSetup setup{static_cast<std::int32_t>(0x7FFFFFFFU / static_cast<std::uint32_t>(area)), edge_20, edge_01};
  SmallPlane depth = setup.plane(v0.depth, static_cast<std::int32_t>(v1.depth - v0.depth),
                                 static_cast<std::int32_t>(v2.depth - v0.depth));
  // Red and blue share a word as two 8.8 values, green has its own: values never leave 0..255, see channel_start.
  std::uint32_t red_blue = 0, red_blue_x = 0, red_blue_y = 0;
  std::uint32_t green = 0, green_x = 0, green_y = 0;
  if constexpr (gouraud) {
    const SmallPlane r = setup.channel(colours[0]->r, colours[1]->r, colours[2]->r);
    const SmallPlane b = setup.channel(colours[0]->b, colours[1]->b, colours[2]->b);
    red_blue = (r.start << 16) + b.start;
    red_blue_x = (r.step_x << 16) + b.step_x;
    red_blue_y = (r.step_y << 16) + b.step_y;
    const SmallPlane g = setup.channel(colours[0]->g, colours[1]->g, colours[2]->g);
    green = g.start;
    green_x = g.step_x;
    green_y = g.step_y;
  }

  const auto skipped_columns = static_cast<std::uint32_t>(box.left - anchor_x);
  const auto skipped_rows = static_cast<std::uint32_t>(box.top - anchor_y);
  if ((skipped_columns | skipped_rows) != 0) {  // the strip or the picture cuts the box
    row.word += edges_x * skipped_columns + edges_y * skipped_rows;
    depth.start += depth.step_x * skipped_columns + depth.step_y * skipped_rows;
    red_blue += red_blue_x * skipped_columns + red_blue_y * skipped_rows;
    green += green_x * skipped_columns + green_y * skipped_rows;
  }

  std::uint16_t* depth_row = target.depth_row(box.top) + (box.left - target.area.left);
  std::uint16_t* colour_row = target.colour_row(box.top) + (box.left - target.area.left);
  const std::int32_t width = box.width();
  for (std::int32_t rows = box.height(); rows != 0; --rows) {
    PackedEdges edges = row;
    std::int32_t i = 0;
    while (!edges.inside()) {
      edges.word += edges_x;
      if (++i == width) break;
    }
    if (i != width) {
      const auto skipped = static_cast<std::uint32_t>(i);
      std::uint32_t z = depth.start + depth.step_x * skipped;
      std::uint32_t rb = red_blue + red_blue_x * skipped;
      std::uint32_t g = green + green_x * skipped;
      do {
        if constexpr (statistics) ++target.statistics->fragments;
        if (rule.draws(z, depth_row[i])) {
          if constexpr (gouraud) {
            colour_row[i] =
                static_cast<std::uint16_t>(((rb >> 16) & 0xF800U) | ((rb >> 11) & 0x1FU) | ((g >> 5) & 0x7E0U));
          } else {
            colour_row[i] = flat_colour;
          }
          if constexpr (statistics) ++target.statistics->depth_passes;
        }
        z += depth.step_x;
        rb += red_blue_x;
        g += green_x;
        edges.word += edges_x;
      } while (++i != width && edges.inside());
    }
    row.word += edges_y;
    depth.start += depth.step_y;
    red_blue += red_blue_y;
    green += green_y;
    depth_row += target.depth_stride;
    colour_row += target.colour_stride;
  }
}

}  // namespace zstrip::detail
