// A clipped and snapped polygon, cut into triangles.
#pragma once

#include <algorithm>
#include <cstdint>

#include "zstrip/geometry/clip.hpp"
#include "zstrip/raster/plane.hpp"

namespace zstrip::detail {

/// At most kMaxPolygon vertices. Snapping can make a convex polygon slightly concave, so a fan would overlap the
/// neighbours: it is cut by ears instead.
class RasterPolygon {
 public:
  void append(const RasterVertex& vertex) { vertices_[count_++] = vertex; }

  /// The pixels that it can cover; an empty rectangle of less than three vertices.
  Rect box() const {
    if (count_ < 3) return {};
    Rect box{INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN};
    for (int i = 0; i < count_; ++i) {
      const std::int32_t x = vertices_[i].x >> 4;
      const std::int32_t y = vertices_[i].y >> 4;
      box = {std::min(box.left, x), std::min(box.top, y), std::max(box.right, x), std::max(box.bottom, y)};
    }
    return box;
  }

  /// Makes the winding counter-clockwise; false if there is nothing to draw.
  bool face_front(bool double_sided) {
    std::int64_t area = 0;
    for (int i = 1; i + 1 < count_; ++i) area += signed_area(vertices_[0], vertices_[i], vertices_[i + 1]);
    if (area == 0 || (area < 0 && !double_sided)) return false;
    if (area < 0) std::reverse(vertices_ + 1, vertices_ + count_);
    return true;
  }

  /// Takes one triangle of positive area off the polygon; false when none is left.
  bool cut_triangle(RasterVertex (&corner)[3]) {
    while (count_ >= 3) {
      const int ear = find_ear();
      const int before = ear == 0 ? count_ - 1 : ear - 1;
      const int after = ear + 1 == count_ ? 0 : ear + 1;
      corner[0] = vertices_[before];
      corner[1] = vertices_[ear];
      corner[2] = vertices_[after];
      std::copy(vertices_ + ear + 1, vertices_ + count_, vertices_ + ear);
      --count_;
      if (signed_area(corner[0], corner[1], corner[2]) > 0) return true;
    }
    return false;
  }

 private:
  /// A vertex whose triangle with its neighbours is not clockwise and holds no other vertex; the first vertex where
  /// rounding left none.
  int find_ear() const {
    for (int i = 0; i < count_; ++i) {
      const int before = i == 0 ? count_ - 1 : i - 1;
      const int after = i + 1 == count_ ? 0 : i + 1;
      if (signed_area(vertices_[before], vertices_[i], vertices_[after]) < 0) continue;
      bool empty = true;
      for (int k = 0; k < count_ && empty; ++k) {
        empty = k == i || k == before || k == after || !strictly_inside(vertices_[k], before, i, after);
      }
      if (empty) return i;
    }
    return 0;
  }
  bool strictly_inside(const RasterVertex& v, int a, int b, int c) const {
    return signed_area(vertices_[a], vertices_[b], v) > 0 && signed_area(vertices_[b], vertices_[c], v) > 0 &&
           signed_area(vertices_[c], vertices_[a], v) > 0;
  }

  RasterVertex vertices_[kMaxPolygon];
  int count_ = 0;
};

}  // namespace zstrip::detail
