// Cuts a clipped and snapped polygon into triangles that cover it once; see polygon.hpp.
#include "zstrip/raster/polygon.hpp"

#include "zstrip/pixels/edge_walk.hpp"

namespace zstrip::detail {

int winding_number(const RasterVertex* vertices, int count, std::int32_t column, std::int32_t row, std::int32_t& end) {
  int winding = 0;
  for (int i = 0; i < count; ++i) {
    const RasterVertex* upper = &vertices[i];
    const RasterVertex* lower = &vertices[i + 1 == count ? 0 : i + 1];
    const int turns = upper->y < lower->y ? 1 : -1;  // counter-clockwise: edges on the left go down
    if (turns < 0) std::swap(upper, lower);
    if (row < upper->y >> 4 || row >= lower->y >> 4) continue;
    const std::int32_t first = EdgeWalk(upper->x, upper->y, lower->x, lower->y, row, false).pixel;
    if (first <= column) {
      winding += turns;
    } else {
      end = std::min(end, first);
    }
  }
  return winding;
}

Rect RasterPolygon::box(const RasterVertex* vertices, int count) {
  Rect box{INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN};
  for (int i = 0; i < count; ++i) {
    const std::int32_t x = vertices[i].x >> 4;
    const std::int32_t y = vertices[i].y >> 4;
    box = {std::min(box.left, x), std::min(box.top, y), std::max(box.right, x), std::max(box.bottom, y)};
  }
  return box;
}

std::int64_t RasterPolygon::area_at(int i) const {
  return signed_area(vertices_[before(i)], vertices_[i], vertices_[after(i)]);
}

void RasterPolygon::erase(int i) {
  for (--count_; i < count_; ++i) vertices_[i] = vertices_[i + 1];
}

RasterPolygon::Turns RasterPolygon::drop_straight() {
  Turns turns{};
  for (int i = 0; i < count_;) {
    const std::int64_t area = area_at(i);
    if (area == 0) {  // a straight angle, or an edge there and back; the angles at its neighbours change
      erase(i);
      turns = {};
      i = 0;
      continue;
    }
    (area > 0 ? turns.left : turns.right) = true;
    ++i;
  }
  convex_ = turns.left != turns.right;
  return turns;
}

bool RasterPolygon::face_viewer() {
  const Turns turns = drop_straight();
  if (!turns.right) return turns.left;
  std::int64_t area = 0;
  for (int i = 1; i + 1 < count_; ++i) area += signed_area(vertices_[0], vertices_[i], vertices_[i + 1]);
  if (area < 0) std::reverse(vertices_ + 1, vertices_ + count_);
  return true;
}

bool RasterPolygon::cut_triangle(RasterVertex (&corner)[3]) {
  for (int i = 0; count_ >= 3 && i < count_;) {
    const std::int64_t area = area_at(i);
    if (area < 0) {
      ++i;
      continue;
    }
    corner[0] = vertices_[before(i)];
    corner[1] = vertices_[i];
    corner[2] = vertices_[after(i)];
    erase(i);
    if (area > 0) return true;
    i = 0;
  }
  return false;
}

TriangleParts::TriangleParts(const RasterPolygon& rest, const RasterVertex (&corner)[3], const Rect& area)
    : rest_(rest), corner_(corner) {
  area_ = area.cut_to(RasterPolygon::box(corner, 3));
  if (area_.empty()) area_.bottom = area_.top;
  column_ = area_.left;
}

TriangleParts::Pixels TriangleParts::run_from(std::int32_t column, std::int32_t& end) const {
  end = area_.right;
  if (winding_number(corner_, 3, column, area_.top, end) == 0) return Pixels::outside;
  return rest_.winding_number(column, area_.top, end) == 0 ? Pixels::drawn : Pixels::left_out;
}

bool TriangleParts::row_is_whole() const {
  for (std::int32_t column = area_.left, end; column < area_.right; column = end) {
    if (run_from(column, end) == Pixels::left_out) return false;
  }
  return true;
}

bool TriangleParts::next(Rect& part) {
  for (; area_.top < area_.bottom; ++area_.top, column_ = area_.left) {
    if (column_ == area_.left) {
      part = area_;
      if (rest_.is_convex()) {
        area_.top = area_.bottom;
      } else {
        while (area_.top < area_.bottom && row_is_whole()) ++area_.top;
      }
      part.bottom = area_.top;
      if (part.bottom > part.top) return true;
    }
    while (column_ < area_.right) {
      part = {column_, area_.top, area_.right, area_.top + 1};
      const Pixels pixels = run_from(column_, part.right);
      column_ = part.right;
      if (pixels == Pixels::drawn) return true;
    }
  }
  return false;
}

}  // namespace zstrip::detail
