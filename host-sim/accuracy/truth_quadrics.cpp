// Intersects rays with the unit sphere, in the sphere's own space.
#include "accuracy/truth_quadrics.hpp"

#include <algorithm>
#include <cmath>

namespace zstrip::sim::truth {
namespace {

Vector sum(const Vector& a, double factor, const Vector& b) {
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}

}  // namespace

QuadricTruth::QuadricTruth(const Scene& scene, const Quadric& quadric, const Camera& camera)
    : scene_(scene),
      material_(scene.materials[quadric.material]),
      rows_{},
      centre_(column(quadric.transform, 3)),
      eye_(vector_of(camera.eye, kOne16)),
      right_(vector_of(camera.right, kOne30)),
      up_(vector_of(camera.up, kOne30)),
      back_(vector_of(camera.back, kOne30)),
      focal_(camera.focal / kOne16),
      near_(camera.near_plane / kOne16),
      far_(camera.far_plane / kOne16),
      orthographic_(camera.projection == Projection::orthographic) {
  const Vector a = column(quadric.transform, 0), b = column(quadric.transform, 1), c = column(quadric.transform, 2);
  const double determinant = dot(a, cross(b, c));
  const Vector crossed[3] = {cross(b, c), cross(c, a), cross(a, b)};
  for (int i = 0; i < 3; ++i) rows_[i] = sum({}, 1 / determinant, crossed[i]);
}

Vector QuadricTruth::to_sphere(const Vector& v) const { return {dot(rows_[0], v), dot(rows_[1], v), dot(rows_[2], v)}; }

std::optional<QuadricSample> QuadricTruth::at(double x, double y) const {
  const Vector aside = sum(sum({}, 2 * x / focal_, right_), 2 * y / focal_, up_);
  const Vector ahead = sum({}, -1, back_);
  const Vector from = sum(orthographic_ ? sum(eye_, 1, aside) : eye_, -1, centre_);
  const Vector origin = to_sphere(from), direction = to_sphere(orthographic_ ? ahead : sum(aside, 1, ahead));
  // Solves |origin + w direction| = 1, from the ray's point that is nearest to the centre.
  const double length2 = dot(direction, direction);
  const double closest = -dot(origin, direction) / length2;
  const Vector nearest = sum(origin, closest, direction);
  const double clearance = 1 - dot(nearest, nearest);
  if (clearance <= 0) return std::nullopt;
  const double half = std::sqrt(clearance / length2);
  if (const auto outside = sample(origin, direction, closest - half)) return outside;
  return material_.double_sided ? sample(origin, direction, closest + half) : std::nullopt;
}

std::optional<QuadricSample> QuadricTruth::sample(const Vector& origin, const Vector& direction, double w) const {
  if (w < near_ || w > far_) return std::nullopt;
  const Vector p = sum(origin, w, direction);
  QuadricSample found{.w = w};
  if (material_.lit) {
    const Vector normal = sum(sum(sum({}, p[0], rows_[0]), p[1], rows_[1]), p[2], rows_[2]);
    found.rgb = lit_colour(scene_, material_, normal);
  } else {
    found.rgb = {double(material_.colour.r), double(material_.colour.g), double(material_.colour.b)};
  }
  if (material_.texture == kNoTexture) return found;
  // Longitude across, latitude down: the middle faces +z, the upper edge is the pole +y.
  const Texture& texture = scene_.textures[material_.texture];
  constexpr double kPi = 3.14159265358979323846;
  found.u = std::ldexp(std::atan2(p[0], p[2]) / (2 * kPi) + 0.5, texture.log2_width);
  const double rows = std::ldexp(1.0, texture.log2_height);
  found.v = std::min(std::atan2(std::hypot(p[0], p[2]), p[1]) / kPi * rows, std::nextafter(rows, 0.0));
  const Vector texel = texel_at(texture, found.u, found.v);
  for (std::size_t c = 0; c < 3; ++c) found.rgb[c] = material_.lit ? found.rgb[c] * texel[c] / 255 : texel[c];
  return found;
}

}  // namespace zstrip::sim::truth
