// Affine maps in floating point.
#include "motion/affine.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace zstrip::sim {
namespace {

Vector column(const Affine& a, std::size_t index) { return {a.m[0][index], a.m[1][index], a.m[2][index]}; }

/// Returns the unit vector in the direction of `v`; `otherwise` if `v` is zero.
Vector direction(const Vector& v, const Vector& otherwise) {
  const double length = std::hypot(v[0], v[1], v[2]);
  if (!(length > 1e-12)) return otherwise;
  return {v[0] / length, v[1] / length, v[2] / length};
}

/// Returns a unit vector that is perpendicular to the unit vector `v`.
Vector perpendicular(const Vector& v) {
  return direction(vector_product(v, std::abs(v[0]) < 0.9 ? Vector{1, 0, 0} : Vector{0, 1, 0}), {0, 1, 0});
}

/// Returns the quaternion of the rotation with these columns, orthonormal and right-handed. The row of the largest
/// component is used, for precision.
Quaternion quaternion_of(const Vector& x, const Vector& y, const Vector& z) {
  const std::array<double, 4> squares{1 + x[0] - y[1] - z[2], 1 - x[0] + y[1] - z[2], 1 - x[0] - y[1] + z[2],
                                      1 + x[0] + y[1] + z[2]};
  switch (std::max_element(squares.begin(), squares.end()) - squares.begin()) {
    case 0: return unit({squares[0], y[0] + x[1], x[2] + z[0], y[2] - z[1]});
    case 1: return unit({y[0] + x[1], squares[1], z[1] + y[2], z[0] - x[2]});
    case 2: return unit({x[2] + z[0], z[1] + y[2], squares[2], x[1] - y[0]});
    default: return unit({y[2] - z[1], z[0] - x[2], x[1] - y[0], squares[3]});
  }
}

}  // namespace

double scalar_product(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector vector_product(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector unit(const Vector& v) {
  const double largest = std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
  if (!(largest > 0)) return {};
  const Vector scaled{v[0] / largest, v[1] / largest, v[2] / largest};
  const double length = std::hypot(scaled[0], scaled[1], scaled[2]);
  return {scaled[0] / length, scaled[1] / length, scaled[2] / length};
}

Affine operator*(const Affine& a, const Affine& b) {
  Affine product;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t col = 0; col < 4; ++col) {
      double sum = col == 3 ? a.m[row][3] : 0;
      for (std::size_t k = 0; k < 3; ++k) sum += a.m[row][k] * b.m[k][col];
      product.m[row][col] = sum;
    }
  }
  return product;
}

Vector operator*(const Affine& a, const Vector& p) {
  Vector image{};
  for (std::size_t row = 0; row < 3; ++row) {
    image[row] = a.m[row][0] * p[0] + a.m[row][1] * p[1] + a.m[row][2] * p[2] + a.m[row][3];
  }
  return image;
}

Affine translation(const Vector& by) {
  Affine a;
  for (std::size_t row = 0; row < 3; ++row) a.m[row][3] = by[row];
  return a;
}

Affine scaling(const Vector& by) {
  Affine a;
  for (std::size_t row = 0; row < 3; ++row) a.m[row][row] = by[row];
  return a;
}

Affine rotation(const Quaternion& by) {
  const auto [x, y, z, w] = unit(by);
  Affine a;
  a.m[0] = {1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w), 0};
  a.m[1] = {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w), 0};
  a.m[2] = {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y), 0};
  return a;
}

bool is_diagonal(const Affine& a) {
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      if (row != column && a.m[row][column] != 0) return false;
    }
  }
  return true;
}

double determinant(const Affine& a) { return scalar_product(column(a, 0), vector_product(column(a, 1), column(a, 2))); }

Affine inverse(const Affine& a) {
  const double d = determinant(a);
  const std::array<Vector, 3> rows{vector_product(column(a, 1), column(a, 2)),
                                   vector_product(column(a, 2), column(a, 0)),
                                   vector_product(column(a, 0), column(a, 1))};
  const Vector moved = column(a, 3);
  Affine result;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t col = 0; col < 3; ++col) result.m[row][col] = rows[row][col] / d;
    result.m[row][3] = -scalar_product(rows[row], moved) / d;
  }
  return result;
}

Affine to_affine(const Placement& placement) {
  return translation(placement.translation) * rotation(placement.rotation) * scaling(placement.scale);
}

Placement to_placement(const Affine& a) {
  const Vector along_x = column(a, 0), along_y = column(a, 1), along_z = column(a, 2);
  const Vector x = direction(along_x, direction(vector_product(along_y, along_z), {1, 0, 0}));
  const double overlap = scalar_product(x, along_y);
  const Vector y = direction({along_y[0] - overlap * x[0], along_y[1] - overlap * x[1], along_y[2] - overlap * x[2]},
                             direction(vector_product(along_z, x), perpendicular(x)));
  const Vector z = vector_product(x, y);  // a mirrored map has a negative scale along this axis
  return {.translation = column(a, 3),
          .rotation = quaternion_of(x, y, z),
          .scale = {scalar_product(x, along_x), scalar_product(y, along_y), scalar_product(z, along_z)}};
}

Quaternion about_axis(const Vector& axis, double degrees) {
  const Vector n = direction(axis, {0, 1, 0});
  const double half = degrees * std::numbers::pi / 360;
  return {n[0] * std::sin(half), n[1] * std::sin(half), n[2] * std::sin(half), std::cos(half)};
}

Quaternion from_degrees(const Vector& about) {
  const Affine turned = rotation(about_axis({0, 0, 1}, about[2])) * rotation(about_axis({0, 1, 0}, about[1])) *
                        rotation(about_axis({1, 0, 0}, about[0]));
  return to_placement(turned).rotation;
}

Quaternion unit(const Quaternion& q) {
  const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  return {q[0] / length, q[1] / length, q[2] / length, q[3] / length};
}

Quaternion between(const Quaternion& a, const Quaternion& b, double share) {
  const double cosine = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
  const double angle = std::acos(std::min(std::abs(cosine), 1.0));
  // The rotations are nearly equal: the arc is straight.
  const double sine = std::sin(angle);
  const double from = sine > 1e-6 ? std::sin((1 - share) * angle) / sine : 1 - share;
  const double to = (sine > 1e-6 ? std::sin(share * angle) / sine : share) * (cosine < 0 ? -1 : 1);
  return unit({from * a[0] + to * b[0], from * a[1] + to * b[1], from * a[2] + to * b[2], from * a[3] + to * b[3]});
}

}  // namespace zstrip::sim
