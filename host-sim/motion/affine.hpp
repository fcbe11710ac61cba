// Maps of space in floating point: where things are in models and scene files, before fixed point.
#pragma once

#include <array>

namespace zstrip::sim {

using Vector = std::array<double, 3>;
using Quaternion = std::array<double, 4>;  ///< x, y, z, w

/// Rows of a 3x4 matrix; column 3 is the translation. Maps p to rows * (p, 1).
struct Affine {
  std::array<std::array<double, 4>, 3> m{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
};

double scalar_product(const Vector& a, const Vector& b);
Vector vector_product(const Vector& a, const Vector& b);

/// First `b`, then `a`.
Affine operator*(const Affine& a, const Affine& b);
Vector operator*(const Affine& a, const Vector& point);

Affine translation(const Vector& by);
Affine scaling(const Vector& by);
/// Of any quaternion but zero, whose length does not matter.
Affine rotation(const Quaternion& by);

/// Whether it only scales along the axes and moves.
bool is_diagonal(const Affine& a);
double determinant(const Affine& a);
/// determinant(a) != 0.
Affine inverse(const Affine& a);

/// Scaled, then rotated, then moved.
struct Placement {
  Vector translation{0, 0, 0};
  Quaternion rotation{0, 0, 0, 1};  ///< unit
  Vector scale{1, 1, 1};
};
Affine to_affine(const Placement& placement);
/// Exact for what is a placement; what shears is replaced by one with the same images of the origin and of the x axis.
Placement to_placement(const Affine& a);

/// Of rotations by degrees about x, then y, then z.
Quaternion from_degrees(const Vector& about);
/// A rotation by degrees about an axis of any length but zero.
Quaternion about_axis(const Vector& axis, double degrees);
Quaternion unit(const Quaternion& q);
/// Along the shorter arc, at constant speed; unit quaternions.
Quaternion between(const Quaternion& a, const Quaternion& b, double share);

}  // namespace zstrip::sim
