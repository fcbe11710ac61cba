// The strip that is being drawn: the addresses of its pixels and its z-buffer, and its area in raster coordinates.
#pragma once

#include <cstdint>

#include "zstrip/base/statistics.hpp"
#include "zstrip/view.hpp"

namespace zstrip::detail {

/// The part of the strip inside the bounding rectangle of the scene. Pixels outside it are never touched.
struct StripTarget {
  Rect area;                         ///< raster pixels: relative to pixel (width / 2, height / 2)
  std::int32_t view_left, view_top;  ///< the picture's upper left corner in raster pixels: planes are anchored to the
                                     ///< picture, not to the strip
  std::int32_t first_column, first_row;  ///< upper left corner of the bounding rectangle, raster pixels
  std::uint16_t* depth;                  ///< the cell of (area.left, area.top); points to 32-bit cells in two formats
  std::uint16_t* colour;                 ///< the pixel of (area.left, area.top), RGB565
  std::int32_t depth_stride;             ///< cells from one row to the next
  std::int32_t colour_stride;            ///< pixels from one row to the next
  Statistics* statistics;                ///< only with effect::statistics

  template <class Cell = std::uint16_t>
  Cell* depth_row(std::int32_t y) const {
    return reinterpret_cast<Cell*>(depth) + (y - area.top) * depth_stride;
  }
  std::uint16_t* colour_row(std::int32_t y) const { return colour + (y - area.top) * colour_stride; }
};

template <class Cell, class Target>
Target part_of(const Target& target, const Rect& part) {
  Target result = target;
  const std::int32_t columns = part.left - target.area.left;
  result.depth = reinterpret_cast<std::uint16_t*>(target.template depth_row<Cell>(part.top) + columns);
  result.colour = target.colour_row(part.top) + columns;
  result.area = part;
  return result;
}

struct TextureView {
  const std::uint16_t* texels;
  std::uint8_t log2_width, log2_height;
};

/// Values that the pixels of a triangle need in addition to its vertices.
struct Surface {
  std::uint16_t flat_colour;
  TextureView texture;
  std::int64_t depth_offset;         ///< DepthFit::offset
  bool has_far_coordinates = false;  ///< the mesh may have texture coordinates that are 2^14 texels apart
};

}  // namespace zstrip::detail
