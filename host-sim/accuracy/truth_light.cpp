// The formulae of light and fog.
#include "accuracy/truth_light.hpp"

#include <algorithm>
#include <cmath>

#include "zstrip/effects.hpp"

namespace zstrip::sim::truth {

Vector vector_of(const Vec3& v, double one) { return {v.x / one, v.y / one, v.z / one}; }
double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vector normalised(const Vector& a) {
  const double length = std::sqrt(dot(a, a));
  return length == 0 ? a : Vector{a[0] / length, a[1] / length, a[2] / length};
}

Vector column(const Transform& transform, std::size_t index) {
  return {transform.m[0][index] / kOne16, transform.m[1][index] / kOne16, transform.m[2][index] / kOne16};
}

Vector transformed(const Transform& transform, const Vector& p, bool direction) {
  Vector out{};
  for (std::size_t row = 0; row < 3; ++row) {
    const Fixed(&m)[4] = transform.m[row];
    out[row] = (m[0] * p[0] + m[1] * p[1] + m[2] * p[2] + (direction ? 0 : m[3])) / kOne16;
  }
  return out;
}

Vector lit_colour(const Scene& scene, const Material& material, const Vector& normal) {
  const Colour emissive = finish_of(scene, material).emissive;
  Vector light{double(scene.ambient.r), double(scene.ambient.g), double(scene.ambient.b)};
  const Vector unit = normalised(normal);
  for (const DirectionalLight& l : scene.lights) {
    const double cosine = dot(unit, normalised({double(l.x), double(l.y), double(l.z)}));
    if (cosine <= 0) continue;
    light[0] += cosine * l.colour.r;
    light[1] += cosine * l.colour.g;
    light[2] += cosine * l.colour.b;
  }
  const Vector own{double(material.colour.r), double(material.colour.g), double(material.colour.b)};
  const Vector added{double(emissive.r), double(emissive.g), double(emissive.b)};
  Vector rgb{};
  for (std::size_t c = 0; c < 3; ++c) rgb[c] = std::min(own[c] * light[c] / 255 + added[c], 255.0);
  return rgb;
}

Vector texel_at(const Texture& texture, double u, double v) {
  const std::int64_t width = std::int64_t{1} << texture.log2_width;
  const std::int64_t height = std::int64_t{1} << texture.log2_height;
  const auto wrapped = [](double at, std::int64_t size) {
    return static_cast<std::size_t>(((static_cast<std::int64_t>(std::floor(at)) % size) + size) % size);
  };
  const std::uint16_t texel = texture.texels[wrapped(v, height) * static_cast<std::size_t>(width) + wrapped(u, width)];
  return {(texel >> 11) * 255.0 / 31, ((texel >> 5) & 63) * 255.0 / 63, (texel & 31) * 255.0 / 31};
}

double visible_share(const Fog& fog, double w) {
  const double density = fog.density / kOne16 * w;
  switch (fog.mode) {
    case FogMode::linear: {
      const double start = fog.start / kOne16, end = fog.end / kOne16;
      return std::clamp((end - w) / (end - start), 0.0, 1.0);
    }
    case FogMode::exponential: return std::exp(-density);
    case FogMode::exponential_squared: break;
  }
  return std::exp(-density * density);
}

}  // namespace zstrip::sim::truth
