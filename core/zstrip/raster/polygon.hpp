// Cuts a clipped and snapped polygon into triangles that cover it once.
//
// Snapping moves the vertices of a convex polygon by up to half a sub-pixel. The polygon may then be concave or, seen
// edge-on, fold over itself. The drawn pixels are those around which it winds counter-clockwise. Winding numbers of
// polygons that share an edge add up to that of their union, so that a fold neither covers a neighbour nor leaves a
// hole.
#pragma once

#include <algorithm>
#include <cstdint>

#include "zstrip/geometry/clip.hpp"
#include "zstrip/pixels/plane.hpp"

namespace zstrip::detail {

/// Returns the winding number of a closed polygon around the centre of pixel (column, row), positive if
/// counter-clockwise. By the fill rule a centre on an edge lies to the right of it, or below it. `end` becomes the next
/// column in which the number may change, if that column is before `end`.
int winding_number(const RasterVertex* vertices, int count, std::int32_t column, std::int32_t row, std::int32_t& end);

class RasterPolygon {
 public:
  void append(const RasterVertex& vertex) { vertices_[count_++] = vertex; }

  /// Returns the pixels that the polygon can cover; empty with less than three vertices.
  Rect box() const { return count_ < 3 ? Rect{} : box(vertices_, count_); }
  static Rect box(const RasterVertex* vertices, int count);

  /// Drops vertices that the outline does not need; with `double_sided` it also makes the winding counter-clockwise.
  /// Returns false if there is nothing to draw.
  bool face_front(bool double_sided) { return double_sided ? face_viewer() : drop_straight().left; }

  /// True if no triangle that is cut off covers more than the polygon. Valid after face_front().
  bool is_convex() const { return convex_; }

  /// Cuts a triangle of positive area off the polygon. Returns false if the rest winds clockwise or is empty.
  bool cut_triangle(RasterVertex (&corner)[3]);

  /// Returns the winding number of the remaining polygon around a pixel's centre.
  int winding_number(std::int32_t column, std::int32_t row, std::int32_t& end) const {
    return detail::winding_number(vertices_, count_, column, row, end);
  }

 private:
  int before(int i) const { return i == 0 ? count_ - 1 : i - 1; }
  int after(int i) const { return i + 1 == count_ ? 0 : i + 1; }
  std::int64_t area_at(int i) const;
  void erase(int i);
  struct Turns {
    bool left, right;
  };
  /// Drops vertices that the outline does not need. Returns the directions in which the outline bends.
  Turns drop_straight();
  bool face_viewer();

  RasterVertex vertices_[kMaxPolygon];
  int count_ = 0;
  bool convex_ = true;
};

/// The parts of an area in which a triangle that was cut off a polygon is drawn. A pixel of the triangle belongs to the
/// polygon and to none of the later triangles if the rest of the polygon does not wind around it. A convex polygon
/// gives one part; other polygons give bands of rows without omitted pixels, and single runs.
class TriangleParts {
 public:
  /// `rest` is the polygon after `corner` was cut off; both must outlive this object.
  TriangleParts(const RasterPolygon& rest, const RasterVertex (&corner)[3], const Rect& area);

  /// Returns the next part, in raster pixels inside the area, from top to bottom; false after the last one.
  bool next(Rect& part);

 private:
  enum class Pixels { outside, drawn, left_out };
  /// Classifies the pixels from `column` on, and sets `end` to the first one that may differ.
  Pixels run_from(std::int32_t column, std::int32_t& end) const;
  bool row_is_whole() const;

  const RasterPolygon& rest_;
  const RasterVertex (&corner_)[3];
  Rect area_;            ///< rows from `top` on are still to be returned
  std::int32_t column_;  ///< the first column of row `top` that is still to be returned
};

}  // namespace zstrip::detail
