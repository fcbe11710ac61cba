// The data of the kernels of medium triangles: the triangle, and the values that a scan of its rows steps.
#pragma once

#include <cstddef>
#include <cstdint>

#include "zstrip/base/processor.hpp"
#include "zstrip/geometry/project.hpp"
#include "zstrip/pixels/edge_walk.hpp"
#include "zstrip/pixels/target.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::detail {

/// A narrow triangle whose first vertex is the highest; if several are, the leftmost of them.
struct MediumTriangle {
  const StripTarget& target;
  const SnappedVertex &v0, &v1, &v2;
  std::int32_t area;  ///< twice the signed area, > 0
};

/// True if words of 32 bits suffice for the planes of a triangle whose area is below 2^25, whatever their values are:
/// see fits_words. `longest`: of its sides along x and y.
constexpr bool sides_fit_words(std::int32_t longest, std::int32_t area) {
  if (kHasThumb1 && longest >> 13 != 0) return false;
  return longest <= area >> (kHasThumb1 ? 1 : 2);
}

/// True if words of 32 bits suffice for the planes of a triangle, except for channels that change steeply. On the
/// longer side of its box (`width`, `height`) as base, the triangle must be at least a quarter of a pixel high, and the
/// vertices' depths must be within half of the range. For Thumb-1 the height is an eighth, and sides must be below 512
/// pixels.
inline bool fits_words(const MediumTriangle& t, std::int32_t width, std::int32_t height) {
  // Compares halves, because differences of whole depths need 33 bits.
  const auto near_first = [&t](const SnappedVertex& v) {
    return static_cast<std::int32_t>((t.v0.depth >> 1) - (v.depth >> 1) + (std::uint32_t{1} << 30));
  };
  return sides_fit_words(width < height ? height : width, t.area) && t.area >> 25 == 0 &&
         (near_first(t.v1) | near_first(t.v2)) >= 0;
}

/// The rows of a triangle, from top to bottom. The assembly depends on the order of the members.
struct MediumRows {
  EdgeWalk left, right;        ///< the edges at the next row, in pixels from the anchor's column; the denominator is
                               ///< subtracted from remainders
  std::uint16_t* depth_row;    ///< the cell in the next row and the anchor's column
  std::uint16_t* colour_row;   ///< the pixel in the next row and the anchor's column
  std::int32_t depth_stride;   ///< bytes
  std::int32_t colour_stride;  ///< bytes

  void set_target(const StripTarget& target, std::int32_t row, std::int32_t anchor_x) {
    depth_row = target.depth_row(row) + (anchor_x - target.area.left);
    colour_row = target.colour_row(row) + (anchor_x - target.area.left);
    depth_stride = target.depth_stride * 2;
    colour_stride = target.colour_stride * 2;
  }
  void go_down() {
    go_down(left), go_down(right);
    depth_row = below(depth_row, depth_stride);
    colour_row = below(colour_row, colour_stride);
  }

 private:
  static void go_down(EdgeWalk& edge) {
    edge.remainder += edge.remainder_step;
    const bool carry = edge.remainder < edge.remainder_step;
    edge.pixel += edge.step + (carry ? 1 : 0);
    if (carry) edge.remainder -= edge.denominator;
  }
  static std::uint16_t* below(std::uint16_t* row, std::int32_t bytes) {
    return reinterpret_cast<std::uint16_t*>(reinterpret_cast<std::byte*>(row) + bytes);
  }
};

/// Values that all planes of a triangle share, in the order of the assembly's registers.
struct SharedOfPlanes {
  std::int32_t mantissa;
  std::int32_t down_2, right_2, down_1, right_1;  ///< shifted weights of vertices 2 and 1
  std::int32_t to_anchor_x, to_anchor_y;          ///< from vertex 0 to the anchor's centre, sub-pixels
};

/// All values of a scan, in memory: set-up and scan are short only if neither keeps the other's values in registers.
struct MediumScan {
  /// The values with planes: depth in 16.16 codes, channels in 8.16.
  enum Value { depth, red, green, blue };
  MediumRows rows;            // The assembly depends on the order of the members.
  std::uint32_t start[4];     ///< start of each Value at the current row
  std::uint32_t step_y[4];    ///< step a row
  std::uint32_t step_x[4];    ///< step a pixel
  std::uint16_t flat_colour;  ///< used if there are no channels
  bool has_channels;
  std::int32_t area;                ///< twice the signed area
  std::int32_t anchor_x, anchor_y;  ///< a pixel near the triangle
  Colour colours[3];                ///< colours of the vertices, if there are channels
  SharedOfPlanes shared;            ///< for further planes

  std::uint32_t at(Value value, std::int32_t column) const {
    return start[value] + step_x[value] * static_cast<std::uint32_t>(column);
  }
  void set_colours(const Colour* const* of_vertices) {
    for (int i = 0; i < 3; ++i) {
      // GCC would call memcpy to copy a colour, which need not be aligned, if words must be aligned.
      if constexpr (kHasThumb1) {
        colours[i].r = of_vertices[i]->r, colours[i].g = of_vertices[i]->g, colours[i].b = of_vertices[i]->b;
      } else {
        colours[i] = *of_vertices[i];
      }
    }
  }
};

}  // namespace zstrip::detail
