// The judge of polygons that may cross themselves: how often an outline winds around a pixel's centre, in 128-bit
// integers, by the crossings of a ray straight up. Shares no code with core.
#pragma once

#include <span>

#include "triangle_oracle.hpp"

namespace oracle {

/// Positive for counter-clockwise as seen on the screen, where y grows downwards. The top-left rule is that of a centre
/// moved to the right by an infinitesimal, and down by the square of it.
inline int winding_number(std::span<const Point> outline, std::int64_t column, std::int64_t row) {
  const Point centre{column * 16 + 8, row * 16 + 8};
  int winding = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point& from = outline[i];
    const Point& to = outline[(i + 1) % outline.size()];
    const bool leftwards = to.x < from.x;
    const Point& left = leftwards ? to : from;
    const Point& right = leftwards ? from : to;
    if (centre.x < left.x || centre.x >= right.x) continue;
    // > 0: the edge passes above the centre; on it, its slope says where it is an infinitesimal to the right.
    Wide above = static_cast<Wide>(right.x - left.x) * (centre.y - left.y) -
                 static_cast<Wide>(right.y - left.y) * (centre.x - left.x);
    if (above == 0) above = right.y <= left.y ? 1 : -1;
    if (above > 0) winding += leftwards ? 1 : -1;
  }
  return winding;
}

}  // namespace oracle
