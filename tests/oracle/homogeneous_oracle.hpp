// The judge of a triangle in space: which pixels see it, through any part of near plane and guard band. Edge functions
// in homogeneous coordinates (Olano and Greer, "Triangle Scan Conversion using 2D Homogeneous Coordinates", 1997), in
// long double, without clipping and without snapping; so it abstains close to an edge.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace oracle {

/// Before the division: x and y in pixels from the picture's upper left corner times w, w the distance.
struct Homogeneous {
  long double x, y, w;
};

enum class Verdict { outside, inside, abstains };

class SpaceTriangle {
 public:
  /// Near and far are distances; `tolerance` in pixels is how close to an edge the oracle abstains.
  SpaceTriangle(const std::array<Homogeneous, 3>& v, long double near, long double far, long double tolerance)
      : v_(v), near_(near), far_(far), tolerance_(tolerance) {
    for (std::size_t i = 0; i < 3; ++i) edge_[i] = cross(v[(i + 1) % 3], v[(i + 2) % 3]);
    determinant_ = v[0].x * edge_[0].x + v[0].y * edge_[0].y + v[0].w * edge_[0].w;
    for (Homogeneous& e : edge_) e = {e.x / determinant_, e.y / determinant_, e.w / determinant_};
  }

  /// Seen edge-on, or no triangle at all.
  bool degenerate() const { return !(std::abs(determinant_) > 1e-12L); }
  /// Counter-clockwise with y up.
  bool front_facing() const { return determinant_ < 0; }

  Verdict sees(int column, int row) const {
    const long double x = column + 0.5L, y = row + 0.5L;
    Verdict verdict = Verdict::inside;
    for (const Homogeneous& e : edge_) verdict = both(verdict, side(e, x, y));
    const Homogeneous one_over_w{edge_[0].x + edge_[1].x + edge_[2].x, edge_[0].y + edge_[1].y + edge_[2].y,
                                 edge_[0].w + edge_[1].w + edge_[2].w};
    verdict = both(verdict, side({-one_over_w.x, -one_over_w.y, 1 / near_ - one_over_w.w}, x, y));
    return both(verdict, side({one_over_w.x, one_over_w.y, one_over_w.w - 1 / far_}, x, y));
  }

  /// Of a value that is linear in space, at a pixel's centre.
  long double value(int column, int row, const std::array<long double, 3>& values) const {
    long double sum = 0, weights = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const long double weight = edge_[i].x * (column + 0.5L) + edge_[i].y * (row + 0.5L) + edge_[i].w;
      sum += weight * values[i];
      weights += weight;
    }
    return sum / weights;
  }
  long double distance(int column, int row) const { return value(column, row, {v_[0].w, v_[1].w, v_[2].w}); }

 private:
  static Homogeneous cross(const Homogeneous& a, const Homogeneous& b) {
    return {a.y * b.w - a.w * b.y, a.w * b.x - a.x * b.w, a.x * b.y - a.y * b.x};
  }
  static Verdict both(Verdict a, Verdict b) {
    if (a == Verdict::outside || b == Verdict::outside) return Verdict::outside;
    return a == Verdict::inside ? b : a;
  }
  /// Of the line where the function is zero.
  Verdict side(const Homogeneous& line, long double x, long double y) const {
    const long double at = line.x * x + line.y * y + line.w;
    const long double limit = tolerance_ * std::hypot(line.x, line.y);
    if (at > limit) return Verdict::inside;
    return at < -limit ? Verdict::outside : Verdict::abstains;
  }

  std::array<Homogeneous, 3> v_, edge_;
  long double determinant_, near_, far_, tolerance_;
};

}  // namespace oracle
