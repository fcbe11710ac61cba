// Medium triangles in blocks, by the planes of portable/medium_triangle.hpp.
#include "zstrip/kernels/vector/medium_triangle.hpp"

#include <algorithm>

#include "zstrip/kernels/portable/medium_triangle.hpp"
#include "zstrip/kernels/vector/blocks.hpp"

#if ZSTRIP_HAS_VECTORS

namespace zstrip::detail {

using namespace vectors;

namespace {

template <bool gouraud>
[[gnu::always_inline]] inline bool draw(const MediumTriangle& t, const Colour* const* colours,
                                        std::uint16_t flat_colour) {
  const auto [min_x, max_x] = std::minmax<std::int32_t>({t.v0.x, t.v1.x, t.v2.x});
  const std::int32_t min_y = t.v0.y, max_y = std::max(t.v1.y, t.v2.y);
  const std::int32_t width = max_x - min_x, height = max_y - min_y;
  if (width + height >= kMediumExtent || !fits_words(t, width, height)) return false;
  const Rect box = Rect{min_x >> 4, min_y >> 4, max_x >> 4, max_y >> 4}.cut_to(t.target.area);
  if (box.empty()) return true;
  const Blocks blocks(t.target, box);
  if (!blocks.fit()) return false;

  MediumScan scan;
  scan.area = t.area;
  scan.anchor_x = std::max(min_x >> 4, t.target.view_left), scan.anchor_y = std::max(min_y >> 4, t.target.view_top);
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
    // 16.16, so that all that counts of a channel is in the upper half.
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

}  // namespace

bool draw_medium_flat_vector(const MediumTriangle& triangle, std::uint16_t colour) {
  return draw<false>(triangle, nullptr, colour);
}

bool draw_medium_gouraud_vector(const MediumTriangle& triangle, const Colour* const (&colours)[3]) {
  return draw<true>(triangle, colours, 0);
}

}  // namespace zstrip::detail

#endif
