// Data that set-up and rows of medium textured triangles share.
#pragma once

#include <cstdint>

#include "zstrip/kernels/medium_scan.hpp"
#include "zstrip/raster/plane.hpp"

namespace zstrip::detail {

/// All that rows need but their run, in memory: set-up and rows are short only if neither holds the other's registers.
struct TexturedScan {
  /// Whose planes, beside depth and light, which are those of `scan`: TextureCoordinates'. Without perspective there is
  /// no 1/w.
  enum Value { one_over_w, u_over_w, v_over_w };

  // The members stand where the assembly expects them.
  MediumScan scan;                             ///< its starts are at the anchor, too
  std::uint32_t start[3];                      ///< of each Value at the anchor
  std::uint32_t step_y[3];                     ///< a row
  std::uint32_t step_x[3];                     ///< a pixel
  std::int32_t base_u, base_v;                 ///< TextureCoordinates'
  std::uint32_t to_fraction_u, to_fraction_v;  ///< TextureAxis'
  std::int32_t right_shift;                    ///< after the division by w, for a 1/w that is normalised by 0
  std::int32_t row;                            ///< the next one, from the anchor's

  void set(Value value, const Plane& plane) {
    start[value] = plane.start, step_y[value] = plane.step_y, step_x[value] = plane.step_x;
  }
  /// In the next row.
  std::uint32_t at(Value value, std::int32_t column) const {
    return Plane{start[value], step_x[value], step_y[value]}.at(column, row);
  }
  std::uint32_t at(MediumScan::Value value, std::int32_t column) const {
    return Plane{scan.start[value], scan.step_x[value], scan.step_y[value]}.at(column, row);
  }
};

}  // namespace zstrip::detail
