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
/// Zero stays zero.
Vector normalised(const Vector& a);
/// Of the matrix; the fourth is the translation.
Vector column(const Transform& transform, std::size_t index);
/// Without the translation if `direction`.
Vector transformed(const Transform& transform, const Vector& p, bool direction);

/// 0..255 a channel, of a surface without texture and vertex colours. `normal`: any length.
Vector lit_colour(const Scene& scene, const Material& material, const Vector& normal);

/// The texel in which a place lies, in texels; textures repeat.
Vector texel_at(const Texture& texture, double u, double v);

/// The part of a colour that is seen through the fog at distance w along the viewing direction.
double visible_share(const Fog& fog, double w);

}  // namespace zstrip::sim::truth
