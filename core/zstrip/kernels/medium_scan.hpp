// Data of the kernels of medium triangles, for all implementations: the triangle, and the values that a scan of its
// rows steps.
#pragma once

#include <cstddef>
#include <cstdint>

#include "zstrip/geometry/project.hpp"
#include "zstrip/kernels/processor.hpp"
#include "zstrip/raster/edge_walk.hpp"
#include "zstrip/raster/target.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::detail {

/// A narrow triangle, its first vertex the highest, then the leftmost.
struct MediumTriangle {
  const StripTarget& target;
  const SnappedVertex &v0, &v1, &v2;
  std::int32_t area;  ///< twice the signed area, > 0
};

/// True if words of 32 bits suffice for the planes of a triangle, but for channels that change steeply: where the
/// longer side of its box, of `width` and `height`, is its base it is a quarter of a pixel high, and its vertices'
/// depths are within half of the range. For Thumb-1 it is an eighth high, and sides are below 512 pixels.
inline bool fits_words(const MediumTriangle& t, std::int32_t width, std::int32_t height) {
  // Halves are compared, because differences of whole depths need 33 bits.
  const auto near_first = [&t](const SnappedVertex& v) {
    return static_cast<std::int32_t>((t.v0.depth >> 1) - (v.depth >> 1) + (std::uint32_t{1} << 30));
  };
  if (kHasThumb1 && (width | height) >> 13 != 0) return false;
  return (width < height ? height : width) <= t.area >> (kHasThumb1 ? 1 : 2) && t.area >> 25 == 0 &&
         (near_first(t.v1) | near_first(t.v2)) >= 0;
}

/// The rows of a triangle, on their way down. The members stand where the assembly expects them.
struct MediumRows {
  EdgeWalk left, right;        ///< at the next row, pixels from the anchor's column; remainders less the denominator
  std::uint16_t* depth_row;    ///< of the next row, the anchor's column
  std::uint16_t* colour_row;   ///< likewise
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

/// Values that all planes of a triangle share in assembly, in the order of its registers.
struct SharedOfPlanes {
  std::int32_t mantissa;                          ///< of 1 / area
  std::int32_t down_2, right_2, down_1, right_1;  ///< shifted weights of vertices 2 and 1
  std::int32_t to_anchor_x, to_anchor_y;          ///< from vertex 0 to the anchor's centre, sub-pixels
};

/// All that scanning needs, in memory: set-up and scan are short only if neither holds the other's registers.
struct MediumScan {
  /// Whose planes: depth in 16.16 codes, channels in 8.16.
  enum Value { depth, red, green, blue };
  MediumRows rows;            // The members stand where the assembly expects them.
  std::uint32_t start[4];     ///< of each Value, where the rows are
  std::uint32_t step_y[4];    ///< a row
  std::uint32_t step_x[4];    ///< a pixel
  std::uint16_t flat_colour;  ///< where there are no channels
  bool has_channels;
  std::int32_t area;                ///< twice the signed area
  std::int32_t anchor_x, anchor_y;  ///< a pixel near the triangle
  Colour colours[3];                ///< of the vertices, where there are channels
  SharedOfPlanes shared;            ///< for more planes than these

  std::uint32_t at(Value value, std::int32_t column) const {
    return start[value] + step_x[value] * static_cast<std::uint32_t>(column);
  }
  void set_colours(const Colour* const* of_vertices) {
    for (int i = 0; i < 3; ++i) {
      // Where a word must be aligned and a colour need not be, GCC calls memcpy for a whole one.
      if constexpr (kHasThumb1) {
        colours[i].r = of_vertices[i]->r, colours[i].g = of_vertices[i]->g, colours[i].b = of_vertices[i]->b;
      } else {
        colours[i] = *of_vertices[i];
      }
    }
  }
};

}  // namespace zstrip::detail
