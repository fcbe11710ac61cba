// Bilinear texels, in assembly for Thumb-2.
#pragma once

#include <cstdint>

#include "zstrip/base/processor.hpp"
#include "zstrip/kernels/fragment_run.hpp"
#include "zstrip/pixels/cell_axis.hpp"

namespace zstrip::detail {

/// A run's texels and places, in the order in which the assembly loads them.
struct BilinearRun {
  std::uint32_t step_x, step_y;  ///< CellAxis::step_in_cell
  const std::uint32_t* end;      ///< behind the last colour
  std::uint32_t* colours;
  std::uint32_t green, step_green;  ///< at the left, 8.8, and the step a 1/256 texel; upper half: the row above
  std::uint32_t alpha, step_alpha;
  std::uint32_t u, step_u, v, step_v;                        ///< CellAxis::start, CellAxis::step
  std::uint32_t log2_width, log2_height, to_column, to_row;  ///< shifts
  std::uint32_t column_mask, index_mask;
  const std::uint16_t *texels, *palette;
  std::uint32_t format;  ///< TextureFormat

  BilinearRun(const RunTexels& from, const RunPlace& place, std::uint32_t* to, std::int32_t count)
      : BilinearRun(from, CellAxis(place.u, place.step_u, from.log2_width),
                    CellAxis(place.v, place.step_v, from.log2_height), to, count) {}

 private:
  BilinearRun(const RunTexels& from, const CellAxis& across, const CellAxis& along, std::uint32_t* to,
              std::int32_t count)
      : step_x(across.step_in_cell),
        step_y(along.step_in_cell),
        end(to + count),
        colours(to),
        u(across.start),
        step_u(across.step),
        v(along.start),
        step_v(along.step),
        log2_width(from.log2_width),
        log2_height(from.log2_height),
        to_column(across.to_texel),
        to_row(along.to_texel),
        column_mask((1U << from.log2_width) - 1),
        index_mask((1U << (from.log2_width + from.log2_height)) - 1),
        texels(from.texels),
        palette(from.palette),
        format(static_cast<std::uint32_t>(from.format)) {}
};

/// Fills the run's colours. Alpha is 255.
void fetch_bilinear_thumb2(BilinearRun& run);
/// For textures with alpha, which have no palette.
void fetch_bilinear_alpha_thumb2(BilinearRun& run);

}  // namespace zstrip::detail
