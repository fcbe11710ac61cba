// The judge of a single triangle: exact coverage, depth and attributes in 128-bit integers, straight from the
// definitions. Shares no code with core; slow on purpose.
#pragma once

#include <array>
#include <cstdint>

namespace oracle {

using Wide = __int128;

/// A snapped vertex: 1/16 pixels from the upper left corner of pixel (0, 0); y grows downwards.
struct Point {
  std::int64_t x, y;
};

class Triangle {
 public:
  explicit Triangle(const std::array<Point, 3>& corners) : p_(corners) {
    area_ = cross(p_[0], p_[1], p_[2]);
    if (area_ < 0) {
      std::swap(p_[1], p_[2]);
      swapped_ = true;
      area_ = -area_;
    }
  }

  /// Twice the area without its sign, in 1/256 square pixels.
  Wide area() const { return area_; }

  /// The top-left rule, said as in the D3D11 functional specification, 3.4.2.1: inside, or exactly on a left edge
  /// (not horizontal, on the left side) or on a top edge (horizontal, above the others).
  bool covers(std::int64_t column, std::int64_t row) const {
    if (area_ == 0) return false;
    const Point centre{column * 16 + 8, row * 16 + 8};
    for (int i = 0; i < 3; ++i) {
      const Point& a = p_[static_cast<std::size_t>(i)];
      const Point& b = p_[static_cast<std::size_t>((i + 1) % 3)];
      const Wide side = cross(a, b, centre);
      if (side < 0) return false;
      if (side == 0 && !(is_left(a, b) || is_top(a, b))) return false;
    }
    return true;
  }

  /// Numerator over area() of the value at a pixel's centre that is linear between the corners' values.
  Wide value_times_area(std::int64_t column, std::int64_t row, std::array<std::int64_t, 3> values) const {
    if (swapped_) std::swap(values[1], values[2]);
    const Point centre{column * 16 + 8, row * 16 + 8};
    return cross(p_[1], p_[2], centre) * values[0] + cross(p_[2], p_[0], centre) * values[1] +
           cross(p_[0], p_[1], centre) * values[2];
  }

 private:
  /// Positive where a, b, c turn clockwise on the screen (y down).
  static Wide cross(const Point& a, const Point& b, const Point& c) {
    return static_cast<Wide>(b.x - a.x) * (c.y - a.y) - static_cast<Wide>(b.y - a.y) * (c.x - a.x);
  }
  /// With clockwise corners on the screen, an edge that goes up has the inside on its right: it is a left edge.
  static bool is_left(const Point& a, const Point& b) { return b.y < a.y; }
  static bool is_top(const Point& a, const Point& b) { return b.y == a.y && b.x > a.x; }

  std::array<Point, 3> p_;
  Wide area_ = 0;
  bool swapped_ = false;
};

}  // namespace oracle
