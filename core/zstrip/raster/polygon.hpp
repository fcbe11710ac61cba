// A clipped and snapped polygon, cut into triangles that cover it once.
//
// Snapping moves the vertices of a convex polygon by up to half a sub-pixel. It may become concave, or, where it is
// seen edge-on, fold over itself. Drawn are the pixels around which it winds counter-clockwise. Winding numbers of
// polygons that share an edge add up to that of their union, so that a fold neither covers a neighbour nor leaves a
// hole.
#pragma once

#include <algorithm>
#include <cstdint>

#include "zstrip/geometry/clip.hpp"
#include "zstrip/raster/plane.hpp"

namespace zstrip::detail {

/// The winding number of a closed polygon around the centre of pixel (column, row), positive if counter-clockwise, by
/// the fill rule: a centre on an edge is on its right, or below. `end` is moved to the next column in which it may
/// change, if that comes before.
int winding_number(const RasterVertex* vertices, int count, std::int32_t column, std::int32_t row, std::int32_t& end);

/// At most kMaxPolygon vertices.
class RasterPolygon {
 public:
  void append(const RasterVertex& vertex) { vertices_[count_++] = vertex; }

  /// The pixels that it can cover; an empty rectangle of less than three vertices.
  Rect box() const { return count_ < 3 ? Rect{} : box(vertices_, count_); }
  static Rect box(const RasterVertex* vertices, int count);

  /// Drops vertices that the outline does not need; with `double_sided` makes the winding counter-clockwise. False if
  /// there is nothing to draw.
  bool face_front(bool double_sided) { return double_sided ? face_viewer() : drop_straight().left; }

  /// True if no triangle that is cut off covers more than the polygon; since face_front().
  bool is_convex() const { return convex_; }

  /// Takes one triangle of positive area off the polygon; false when what is left winds clockwise or is nothing.
  bool cut_triangle(RasterVertex (&corner)[3]);

  /// Returns the winding number of a point in the part that is left.
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
  /// Drops vertices that the outline does not need; which turns it makes.
  Turns drop_straight();
  bool face_viewer();

  RasterVertex vertices_[kMaxPolygon];
  int count_ = 0;
  bool convex_ = true;
};

/// The parts of an area in which a triangle that was cut off a polygon is drawn: a pixel of it belongs to the polygon,
/// and to none of the triangles to come, if what is left of the polygon does not wind around it. Of a convex polygon
/// one part; else bands of rows where nothing is left out, and single runs.
class TriangleParts {
 public:
  /// `rest` is what cutting off `corner` has left; both must outlive this.
  TriangleParts(const RasterPolygon& rest, const RasterVertex (&corner)[3], const Rect& area);

  /// Returns the next part, in raster pixels inside the area, from top to bottom; false after the last one.
  bool next(Rect& part);

 private:
  enum class Pixels { outside, drawn, left_out };
  /// From `column` to before `end`, which is set.
  Pixels run_from(std::int32_t column, std::int32_t& end) const;
  bool row_is_whole() const;

  const RasterPolygon& rest_;
  const RasterVertex (&corner_)[3];
  Rect area_;            ///< what is to come, from row `top` on
  std::int32_t column_;  ///< where that begins in the first row
};

}  // namespace zstrip::detail
