// The data that set-up and rows of medium textured triangles share.
#pragma once

#include <cstdint>

#include "zstrip/pixels/medium_scan.hpp"
#include "zstrip/pixels/plane.hpp"

namespace zstrip::detail {

/// The values of a vertex that texels depend on.
struct TexturedVertex {
  std::uint32_t depth;  ///< 16.16 codes
  std::int32_t u, v;    ///< texels, 16.16
};

/// All values of the rows except their run, in memory: set-up and rows are short only if neither keeps the other's
/// values in registers.
struct TexturedScan {
  /// The values with planes, in addition to depth and light in `scan`: those of TextureCoordinates. Without perspective
  /// one_over_w is unused.
  enum Value { one_over_w, u_over_w, v_over_w };

  // The assembly depends on the order of the members.
  MediumScan scan;                             ///< its starts are also at the anchor
  std::uint32_t start[3];                      ///< start of each Value at the anchor
  std::uint32_t step_y[3];                     ///< step a row
  std::uint32_t step_x[3];                     ///< step a pixel
  std::int32_t base_u, base_v;                 ///< from TextureCoordinates
  std::uint32_t to_fraction_u, to_fraction_v;  ///< from TextureAxis
  std::int32_t right_shift;                    ///< shift after the division by w, for a 1/w with normalisation 0
  std::int32_t row;                            ///< the next row, counted from the anchor's

  void set(Value value, const Plane& plane) {
    start[value] = plane.start, step_y[value] = plane.step_y, step_x[value] = plane.step_x;
  }
  /// Returns a value in the next row.
  std::uint32_t at(Value value, std::int32_t column) const {
    return Plane{start[value], step_x[value], step_y[value]}.at(column, row);
  }
  std::uint32_t at(MediumScan::Value value, std::int32_t column) const {
    return Plane{scan.start[value], scan.step_x[value], scan.step_y[value]}.at(column, row);
  }
};

}  // namespace zstrip::detail
