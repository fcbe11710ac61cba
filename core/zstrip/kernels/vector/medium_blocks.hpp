// Draws a medium triangle in blocks, with the planes of portable/medium_triangle.hpp.
#pragma once

#include <algorithm>

#include "zstrip/kernels/portable/medium_triangle.hpp"
#include "zstrip/kernels/vector/blocks.hpp"
#include "zstrip/kernels/vector/medium_triangle.hpp"

#if ZSTRIP_HAS_VECTORS

namespace zstrip::detail::vectors {

/// Implements draw_medium for a triangle in a box, the first of `around`.
template <bool gouraud>
[[gnu::always_inline]] inline bool draw_medium_in_blocks(const MediumTriangle& t, const Boxes& around,
                                                         const Colour* const* colours, std::uint16_t flat_colour) {
  const Halves extent = around.greatest - around.least;
  const auto longer = static_cast<std::int16_t>(signed_max(extent, swapped_in_pairs(extent))[0]);
  if (sum_of_products(extent, in_all_halves(1)) >= kMediumExtent || !fits_words(t, longer, 0)) return false;
  const Rect whole = around.first_box();
  const Rect box = whole.cut_to(t.target.area);
  if (box.empty()) return true;
  const Blocks blocks(t.target, box);
  if (!blocks.fit()) return false;

  MediumScan scan;
  scan.area = t.area;
  scan.anchor_x = std::max(whole.left, t.target.view_left), scan.anchor_y = std::max(whole.top, t.target.view_top);
  scan.has_channels = gouraud;
  if constexpr (gouraud) scan.set_colours(colours);
  if (!set_up_medium_portable(scan, t.v0, t.v1, t.v2)) return false;
  const Words step_x = load_words(scan.step_x), step_y = load_words(scan.step_y);
  Words start = load_words(scan.start);
  const std::int32_t columns = blocks.left - scan.anchor_x, rows = blocks.top - scan.anchor_y;
  if ((columns | rows) != 0) {
    start += step_x * in_all_words(static_cast<std::uint32_t>(columns)) +
             step_y * in_all_words(static_cast<std::uint32_t>(rows));
  }
  const Edges edges(t.v0, t.v1, t.v2);
  const Words exact = edges.at(blocks.left, blocks.top);
  const auto z = WordBlock::of<MediumScan::depth>(start, step_x, step_y);
  if constexpr (gouraud) {
    // Converted to 16.16, so that the upper half has all bits of a channel that are used.
    const Words from = start << 8, right = step_x << 8, down = step_y << 8;
    blocks.draw(edges, exact, z.upper, z.step_x, z.step_y,
                WordChannels{WordBlock::of<MediumScan::red>(from, right, down),
                             WordBlock::of<MediumScan::green>(from, right, down),
                             WordBlock::of<MediumScan::blue>(from, right, down)});
  } else {
    blocks.draw(edges, exact, z.upper, z.step_x, z.step_y, OneColour{in_all_halves(flat_colour)});
  }
  return true;
}

}  // namespace zstrip::detail::vectors

#endif
