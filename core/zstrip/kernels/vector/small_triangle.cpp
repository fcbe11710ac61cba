// Draws small triangles in blocks: computes all three planes from the edge functions at once.
#include "zstrip/kernels/vector/small_triangle.hpp"

#include "zstrip/base/math.hpp"
#include "zstrip/kernels/vector/blocks.hpp"
#include "zstrip/pixels/small_scan.hpp"

#if ZSTRIP_HAS_VECTORS

namespace zstrip::detail {
namespace {

using namespace vectors;

Halves channels_of(const Colour& colour) {
  std::uint32_t bits;
  __builtin_memcpy(&bits, &colour, sizeof bits);
  return bytes_of(bits);
}

/// Computes the planes of SmallChannels.
[[gnu::always_inline]] inline ChannelBlocks channel_blocks(const Weights& weights, std::int32_t inverse_area,
                                                           const Colour* const (&colours)[3], std::int32_t first_column,
                                                           std::int32_t first_row) {
  const Halves first = channels_of(*colours[0]);
  const Weights::Factors differences(channels_of(*colours[1]) - first, channels_of(*colours[2]) - first);
  const Halves at_vertex = (first << 8) + in_all_halves(128);
  const Words inverse = in_all_words(static_cast<std::uint32_t>(inverse_area));
  const auto channel = [&](Words change, Halves start) {
    const Halves plane = as_halves(upper_products<9>(change, inverse));
    const Halves step_x = half_in_all<0>(plane);
    const Halves step_y = half_in_all<2>(plane);
    start += half_in_all<4>(plane);
    if ((first_column | first_row) != 0) {
      start += step_x * in_all_halves(first_column) + step_y * in_all_halves(first_row);
    }
    return ChannelBlock{stepped_halves(start, step_x, step_y), half_in_all<0, 2>(plane), half_in_all<2, 1>(plane)};
  };
  return {channel(weights.sum<0>(differences), half_in_all<0>(at_vertex)),
          channel(weights.sum<1>(differences), half_in_all<1>(at_vertex)),
          channel(weights.sum<2>(differences), half_in_all<2>(at_vertex))};
}

template <bool gouraud>
[[gnu::always_inline]] inline bool draw(const SmallTriangle& t, const Colour* const (&colours)[3],
                                        std::uint16_t flat_colour) {
  const Blocks blocks(t.target, t.box);
  if (!blocks.fit()) return false;
  const Edges edges(t.v0, t.v1, t.v2);
  const Words at_anchor = edges.at(t.anchor_x, t.anchor_y);
  const Weights weights(edges.steps, at_anchor);
  const auto inverse_area = static_cast<std::int32_t>(quotient_31(static_cast<std::uint32_t>(t.area)));
  const auto per_unit = [&](const SnappedVertex& v) {
    const auto difference = static_cast<std::int32_t>(v.depth - t.v0.depth);
    return static_cast<std::uint32_t>(multiply_high_rounded(difference * 2, inverse_area));
  };
  const Words plane = weights.sum(per_unit(t.v1), per_unit(t.v2));
  const Words step_x = word_in_all<0>(plane);
  const Words step_y = word_in_all<1>(plane);
  Words z = word_in_all<2>(plane) + in_all_words(t.v0.depth) + multiples_0_to_3(step_x);
  Words exact = at_anchor;
  const std::int32_t first_column = blocks.left - t.anchor_x;
  const std::int32_t first_row = blocks.top - t.anchor_y;
  if ((first_column | first_row) != 0) {
    exact = edges.at(blocks.left, blocks.top);
    z += in_all_words(step_x[0] * static_cast<std::uint32_t>(first_column) +
                      step_y[0] * static_cast<std::uint32_t>(first_row));
  }
  if constexpr (gouraud) {
    blocks.draw(edges, exact, z, step_x, step_y,
                channel_blocks(weights, inverse_area, colours, first_column, first_row));
  } else {
    blocks.draw(edges, exact, z, step_x, step_y, OneColour{in_all_halves(flat_colour)});
  }
  return true;
}

}  // namespace

bool draw_small_flat_vector(const SmallTriangle& triangle, std::uint16_t colour) {
  return draw<false>(triangle, {}, colour);
}

bool draw_small_gouraud_vector(const SmallTriangle& triangle, const Colour* const (&colours)[3]) {
  return draw<true>(triangle, colours, 0);
}

}  // namespace zstrip::detail

#endif
