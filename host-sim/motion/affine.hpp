// Affine maps in floating point: positions in models and scene files, before the conversion to fixed point.
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
/// Returns the unit vector; zeros for zeros. Precise also if the square of the length does not fit a double.
Vector unit(const Vector& v);

/// Returns the map that applies `b` first, then `a`.
Affine operator*(const Affine& a, const Affine& b);
Vector operator*(const Affine& a, const Vector& point);

Affine translation(const Vector& by);
Affine scaling(const Vector& by);
/// Converts any quaternion except zero; its length does not matter.
Affine rotation(const Quaternion& by);

/// True if the map only scales along the axes and translates.
bool is_diagonal(const Affine& a);
double determinant(const Affine& a);
/// Returns the inverse. determinant(a) != 0.
Affine inverse(const Affine& a);

/// Scales, then rotates, then translates.
struct Placement {
  Vector translation{0, 0, 0};
  Quaternion rotation{0, 0, 0, 1};  ///< unit
  Vector scale{1, 1, 1};
};
Affine to_affine(const Placement& placement);
/// Converts a map; exact if the map is a placement. A map that shears is replaced by a placement with the same images
/// of the origin and of the x axis.
Placement to_placement(const Affine& a);

/// Returns the rotation by degrees about x, then y, then z.
Quaternion from_degrees(const Vector& about);
/// Returns a rotation by degrees about an axis of any length except zero.
Quaternion about_axis(const Vector& axis, double degrees);
Quaternion unit(const Quaternion& q);
/// Interpolates along the shorter arc, at constant speed; unit quaternions.
Quaternion between(const Quaternion& a, const Quaternion& b, double share);

}  // namespace zstrip::sim
