// Rotates billboards in floating point.
#include "motion/turned_billboard.hpp"

#include <algorithm>
#include <cmath>

#include "motion/affine.hpp"

namespace zstrip::sim {
namespace {

constexpr double kUnit = 1 << 30;

Vector of_axis(const Vec3& axis) { return {axis.x / kUnit, axis.y / kUnit, axis.z / kUnit}; }
Vector column(const Transform& t, std::size_t c) {
  return {t.m[0][c] / double{kFixedOne}, t.m[1][c] / double{kFixedOne}, t.m[2][c] / double{kFixedOne}};
}
double length(const Vector& v) { return std::sqrt(scalar_product(v, v)); }
Vector scaled(const Vector& v, double by) { return {v[0] * by, v[1] * by, v[2] * by}; }
/// Returns the part of `v` that is perpendicular to the unit vector `axis`.
Vector across(const Vector& v, const Vector& axis) {
  const double along = scalar_product(v, axis);
  return {v[0] - along * axis[0], v[1] - along * axis[1], v[2] - along * axis[2]};
}

}  // namespace

Transform standing(const Scene& scene, const Instance& instance, const Camera& camera) {
  const Billboard billboard = scene.meshes[instance.mesh].billboard;
  if (billboard == Billboard::none) return instance.transform;
  const Vector right = of_axis(camera.right), back = of_axis(camera.back), y = column(instance.transform, 1);
  std::array<Vector, 3> axes{right, of_axis(camera.up), back};
  if (billboard == Billboard::upright && length(y) > 0) {
    constexpr double kMin = 1.0 / 256;
    axes[1] = scaled(y, 1 / length(y));
    axes[0] = across(right, axes[1]);
    if (std::ranges::all_of(axes[0], [](double c) { return std::abs(c) < kMin; }))
      axes[0] = vector_product(axes[1], back);
    axes[0] = scaled(axes[0], 1 / length(axes[0]));
    axes[2] = vector_product(axes[0], axes[1]);
  }
  Transform turned = instance.transform;
  for (std::size_t c = 0; c < 3; ++c) {
    const double size = length(column(instance.transform, c)) * kFixedOne;
    for (std::size_t r = 0; r < 3; ++r) turned.m[r][c] = static_cast<Fixed>(std::lround(axes[c][r] * size));
  }
  return turned;
}

}  // namespace zstrip::sim
