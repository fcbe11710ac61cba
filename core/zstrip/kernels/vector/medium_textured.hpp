// Draws pixels of medium textured triangles with smooth light: one vector holds a pixel's depth and light.
#pragma once

#include <cstdint>

#include "zstrip/kernels/vector/vector.hpp"
#include "zstrip/pixels/textured_run_state.hpp"
#include "zstrip/pixels/textured_scan.hpp"

#if ZSTRIP_HAS_VECTORS

namespace zstrip::detail {
namespace vectors {

/// Does the same as modulated(). Words 1 to 3 are the light's red, green and blue; each channel has its own word.
inline std::uint16_t modulated(std::uint16_t texel, Words light) {
  const Words factors = (light >> 16) + (light >> 23);
  const Halves channels = as_halves(in_all_words(texel)) * Halves{0, 0, 1, 0, 1 << 5, 0, 1 << 11, 0};
  // The division by 256 leaves 3 fraction bits for red and blue and 2 for green; rounded to nearest.
  const Halves lit =
      upper_products_of_halves(channels & Halves{0, 0, 0xF800, 0, 0xFC00, 0, 0xF800, 0}, as_halves(factors)) +
      Halves{0, 0, 1 << 2, 0, 1 << 1, 0, 1 << 2, 0};
  const Words shifted =
      sums_of_products(lit & Halves{0, 0, 0xFFF8, 0, 0xFFFC, 0, 0xFFF8, 0}, Halves{0, 0, 1 << 11, 0, 1 << 6, 0, 1, 0});
  return static_cast<std::uint16_t>(sum(shifted) >> 3);
}

}  // namespace vectors

/// Draws `length` > 0 pixels of the next row, from `column` on, counted from the anchor's column. `run` has the
/// texture, the start and the steps.
[[gnu::always_inline]] inline void fill_smooth_vector(const LitWordRunState& run, const TexturedScan& textured,
                                                      std::int32_t column, std::int32_t length) {
  using namespace vectors;
  const MediumScan& scan = textured.scan;
  const Words step_x = load_words(scan.step_x);
  Words pixel = load_words(scan.start) + times_half(step_x, in_all_halves(column)) +
                times_half(load_words(scan.step_y), in_all_halves(textured.row));
  std::uint16_t* depth = scan.rows.depth_row + column;
  std::uint16_t* colour = scan.rows.colour_row + column;
  for (std::uint32_t u = run.u, v = run.v;;) {
    const std::uint16_t code = as_halves(pixel)[2 * MediumScan::depth + 1];
    if (*depth < code) {
      *depth = code;
      *colour = modulated(run.texels[((v >> run.to_row) & run.row_mask) + (u >> run.to_column)], pixel);
    }
    if (--length == 0) return;
    ++depth, ++colour;
    pixel += step_x;
    u += run.step_u, v += run.step_v;
  }
}

}  // namespace zstrip::detail

#endif
