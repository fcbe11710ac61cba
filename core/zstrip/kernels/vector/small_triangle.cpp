// Small triangles in blocks: their planes from the edge functions, all three at once.
#include "zstrip/kernels/vector/small_triangle.hpp"

#include <algorithm>
#include <utility>

#include "zstrip/base/math.hpp"
#include "zstrip/kernels/small_scan.hpp"
#include "zstrip/kernels/vector/blocks.hpp"
#include "zstrip/kernels/vector/medium_triangle.hpp"
#include "zstrip/raster/colour.hpp"

#if ZSTRIP_HAS_VECTORS

namespace zstrip::detail {
namespace {

using namespace vectors;

Halves channels_of(const Colour& colour) {
  std::uint32_t bits;
  __builtin_memcpy(&bits, &colour, sizeof bits);
  return bytes_of(bits);
}

/// Grows with y, then x.
std::int32_t order_of(Words place) { return static_cast<std::int32_t>(place[0] ^ 0x8000); }

/// SmallChannels' planes.
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

/// draw_small_run_vector.
template <bool gouraud>
std::uint32_t draw_run(const VectorSmallRun& run, const Triangle* triangles, std::uint32_t count) {
  const StripTarget& target = run.target;
  const Rect& strip = target.area;
  const SnappedVertex* const vertices = run.vertices;
  const Colour* const colours = run.colours;
  const std::uint32_t first_vertex = run.first_vertex;
  for (std::uint32_t i = 0; i < count; ++i) {
    std::uint32_t a = triangles[i].a - first_vertex, b = triangles[i].b - first_vertex,
                  c = triangles[i].c - first_vertex;
    const Words at_a = place_of(vertices[a]), at_b = place_of(vertices[b]), at_c = place_of(vertices[c]);
    // Assembler::narrow_area.
    const Halves a_halves = as_halves(at_a), b_halves = as_halves(at_b), c_halves = as_halves(at_c);
    const Halves to_b = swapped_in_pairs(b_halves - a_halves) * in_all_pairs(1, -1);
    std::int32_t area = sum_of_products(c_halves - a_halves, to_b);
    if (area <= 0 && (gouraud || area == 0 || !run.surface.double_sided)) continue;
    const Words least = as_words(signed_min(signed_min(a_halves, b_halves), c_halves));
    const Words greatest = as_words(signed_max(signed_max(a_halves, b_halves), c_halves));
    const auto low = static_cast<std::int32_t>(least[0]), high = static_cast<std::int32_t>(greatest[0]);
    const std::int32_t min_x = static_cast<std::int16_t>(low), min_y = low >> 16;
    const std::int32_t max_x = static_cast<std::int16_t>(high), max_y = high >> 16;
    const Rect box = Rect{min_x >> 4, min_y >> 4, max_x >> 4, max_y >> 4}.cut_to(strip);
    if (box.empty()) continue;
    const std::int32_t width = max_x - min_x, height = max_y - min_y;
    if (!gouraud && width + height >= kMediumExtent) return i;
    // rotate_to_first: by y, then x.
    const std::int32_t order_a = order_of(at_a), order_b = order_of(at_b), order_c = order_of(at_c);
    const std::uint32_t first = a;
    if (order_b < order_a && order_b < order_c) {
      a = b, b = c, c = first;
    } else if (order_c < order_a) {
      a = c, c = b, b = first;
    }
    if (!gouraud && area < 0) std::swap(b, c), area = -area;
    const SnappedVertex &v0 = vertices[a], &v1 = vertices[b], &v2 = vertices[c];
    const bool small = is_small(width, height, v0, v1, v2);
    const SmallTriangle triangle{target, v0, v1, v2, area, min_x >> 4, min_y >> 4, box};
    if constexpr (gouraud) {
      const Colour* const of_vertices[3] = {colours + a, colours + b, colours + c};
      if (!(small ? draw<true>(triangle, of_vertices, 0)
                  : draw_medium_gouraud_vector({target, v0, v1, v2, area}, of_vertices))) {
        return i;
      }
    } else {
      const std::uint16_t colour =
          colours != nullptr ? rgb565(colours[triangles[i].a - first_vertex]) : run.surface.flat_colour;
      if (!(small ? draw<false>(triangle, {}, colour) : draw_medium_flat_vector({target, v0, v1, v2, area}, colour))) {
        return i;
      }
    }
  }
  return count;
}

}  // namespace

bool draw_small_flat_vector(const SmallTriangle& triangle, std::uint16_t colour) {
  return draw<false>(triangle, {}, colour);
}

bool draw_small_gouraud_vector(const SmallTriangle& triangle, const Colour* const (&colours)[3]) {
  return draw<true>(triangle, colours, 0);
}

std::uint32_t draw_small_run_vector(const VectorSmallRun& run, const Triangle* triangles, std::uint32_t count) {
  return run.surface.flat ? draw_run<false>(run, triangles, count) : draw_run<true>(run, triangles, count);
}

}  // namespace zstrip::detail

#endif
