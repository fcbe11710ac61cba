// Vectors, light, texels and fog of the truth, in double precision as docs/conventions.md defines them.
#pragma once

#include <array>

#include "zstrip/scene.hpp"

namespace zstrip::sim::truth {

using Vector = std::array<double, 3>;

inline constexpr double kOne16 = 65536;       // 16.16
inline constexpr double kOne30 = 1073741824;  // 2.30

Vector vector_of(const Vec3& v, double one);
double dot(const Vector& a, const Vector& b);
Vector cross(const Vector& a, const Vector& b);
/// Returns a unit vector; the zero vector stays zero.
Vector normalised(const Vector& a);
/// Returns a column of the matrix; column 3 is the translation.
Vector column(const Transform& transform, std::size_t index);
/// Transforms a point, or a direction without the translation.
Vector transformed(const Transform& transform, const Vector& p, bool direction);

/// Returns the lit colour of a surface without texture and vertex colours, 0..255 a channel. `normal`: any length.
Vector lit_colour(const Scene& scene, const Material& material, const Vector& normal);

/// Returns the texel that contains a position in texels; textures repeat.
Vector texel_at(const Texture& texture, double u, double v);

/// Returns the part of a colour that is visible through the fog at distance w along the viewing direction.
double visible_share(const Fog& fog, double w);

}  // namespace zstrip::sim::truth
