// A clipped and snapped polygon, cut into triangles that cover it once; see polygon.hpp.
#include "zstrip/raster/polygon.hpp"

#include "zstrip/raster/edge_walk.hpp"

namespace zstrip::detail {

int winding_number(const RasterVertex* vertices, int count, std::int32_t column, std::int32_t row, std::int32_t& end) {
  int winding = 0;
  for (int i = 0; i < count; ++i) {
    const RasterVertex* upper = &vertices[i];
    const RasterVertex* lower = &vertices[i + 1 == count ? 0 : i + 1];
    const int turns = upper->y < lower->y ? 1 : -1;  // counter-clockwise: the edges on the left go down
    if (turns < 0) std::swap(upper, lower);
    if (row < upper->y >> 4 || row >= lower->y >> 4) continue;
    const std::int32_t first = EdgeWalk<std::int64_t>(upper->x, upper->y, lower->x, lower->y, row).pixel;
    if (first <= column) {
      winding += turns;
    } else {
      end = std::min(end, first);
    }
  }
  return winding;
}

bool RasterPolygon::face_front(bool double_sided) {
  bool turns_left = false;
  bool turns_right = false;
  for (int i = 0; i < count_;) {
    const std::int64_t area = area_at(i);
    if (area == 0) {  // straight on, or there and back again: its neighbours' corners become others
      erase(i);
      turns_left = turns_right = false;
      i = 0;
      continue;
    }
    (area > 0 ? turns_left : turns_right) = true;
    ++i;
  }
  convex_ = turns_left != turns_right;
  if (!double_sided || !turns_right) return turns_left;
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
  const auto [min_x, max_x] = std::minmax({corner[0].x, corner[1].x, corner[2].x});
  const auto [min_y, max_y] = std::minmax({corner[0].y, corner[1].y, corner[2].y});
  area_ = {std::max(area.left, min_x >> 4), std::max(area.top, min_y >> 4), std::min(area.right, max_x >> 4),
           std::min(area.bottom, max_y >> 4)};
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
