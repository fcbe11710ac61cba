// What a ray through a pixel's centre meets, in long double, from the scene's own numbers.
#pragma once

#include <cmath>
#include <optional>

#include "zstrip/zstrip.hpp"

namespace ray_oracle {

using namespace zstrip;
using Real = long double;

struct V {
  Real x, y, z;
  friend V operator+(V a, V b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend V operator-(V a, V b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend V operator*(Real s, V a) { return {s * a.x, s * a.y, s * a.z}; }
};
inline Real dot(V a, V b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline V cross(V a, V b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
inline V unit(V a) { return 1 / std::sqrt(dot(a, a)) * a; }

inline Real real(Fixed value) { return value / Real{65536}; }
inline V vector(const Vec3& v, Real scale) { return {v.x / scale, v.y / scale, v.z / scale}; }

/// A ray in world space; origin + w * direction lies at distance w of the camera's plane.
struct Ray {
  V origin, direction;
};

/// Through picture position (x, y) in pixels.
inline Ray ray_through(const Camera& camera, const View& view, Real x, Real y) {
  constexpr Real kUnit = 1 << 30;
  const V right = vector(camera.right, kUnit), up = vector(camera.up, kUnit), back = vector(camera.back, kUnit);
  const V eye = vector(camera.eye, 65536);
  const Real per_pixel = 1 / (real(camera.focal) * view.height / 2);
  const V aside = (x - view.width / Real{2}) * per_pixel * right - (y - view.height / Real{2}) * per_pixel * up;
  if (camera.projection == Projection::orthographic) return {eye + aside, Real{-1} * back};
  return {eye, aside - back};
}

struct Hit {
  Real w;
  V normal;   ///< world, unit, outwards
  V surface;  ///< on the unit sphere
};

/// Where a ray enters and leaves a quadric, and how far it is from only touching it (negative: it misses).
struct Crossing {
  Real clearance;
  Hit enter, leave;
};

inline Crossing cross_quadric(const Ray& ray, const Transform& transform) {
  const auto& m = transform.m;
  const auto column = [&](int c) { return V{real(m[0][c]), real(m[1][c]), real(m[2][c])}; };
  const V a = column(0), b = column(1), c = column(2);
  const Real determinant = dot(a, cross(b, c));
  const V rows[3] = {1 / determinant * cross(b, c), 1 / determinant * cross(c, a), 1 / determinant * cross(a, b)};
  const auto to_sphere = [&](V v) { return V{dot(rows[0], v), dot(rows[1], v), dot(rows[2], v)}; };
  const V o = to_sphere(ray.origin - column(3)), d = to_sphere(ray.direction);
  const Real length2 = dot(d, d);
  const Real closest = -dot(o, d) / length2;
  const V nearest = o + closest * d;
  const Real clearance = 1 - dot(nearest, nearest);
  const Real half = clearance > 0 ? std::sqrt(clearance / length2) : 0;
  const auto hit = [&](Real w) {
    const V p = o + w * d;
    return Hit{w, unit(p.x * rows[0] + p.y * rows[1] + p.z * rows[2]), p};
  };
  return {clearance, hit(closest - half), hit(closest + half)};
}

/// What is seen of a quadric between two distances: the near side, or, where it is cut away and `inside`, the far side.
inline std::optional<Hit> seen(const Crossing& crossing, Real near, Real far, bool inside) {
  const auto within = [&](const Hit& h) { return h.w >= near && h.w <= far; };
  if (crossing.clearance <= 0) return std::nullopt;
  if (within(crossing.enter)) return crossing.enter;
  if (inside && within(crossing.leave)) return crossing.leave;
  return std::nullopt;
}

}  // namespace ray_oracle
