// Rays of a camera and the triangles that they meet, in double precision. Shares nothing with the renderer but the
// scene.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "vectors.hpp"
#include "zstrip/camera.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/view.hpp"

namespace oracle {

struct Ray {
  Point from, along;
  Point at(double distance) const { return from + distance * along; }
};

/// Through (x, y) pixels of a picture; distances on it are those along the viewing direction.
inline Ray ray_through(const zstrip::Camera& camera, const zstrip::View& view, double x, double y) {
  const double focal = std::ldexp(camera.focal, -16) * view.height / 2;
  const Point aside =
      (x - view.width / 2.0) / focal * of_axis(camera.right) - (y - view.height / 2.0) / focal * of_axis(camera.up);
  const Point eye = of_place(camera.eye);
  const Point forwards = -1.0 * of_axis(camera.back);
  if (camera.projection == zstrip::Projection::orthographic) return {eye + aside, forwards};
  return {eye, forwards + aside};
}

struct Facet {
  Point corner[3];
  Point normal() const { return cross(corner[1] - corner[0], corner[2] - corner[0]); }
};

/// A mesh's vertex in the world.
inline Point placed(const zstrip::Mesh& mesh, const zstrip::Transform& transform, std::uint16_t index) {
  const zstrip::Position& p = mesh.positions[index];
  const Point own{std::ldexp(mesh.centre.x, -16) + std::ldexp(mesh.half_extent.x, -31) * p.x,
                  std::ldexp(mesh.centre.y, -16) + std::ldexp(mesh.half_extent.y, -31) * p.y,
                  std::ldexp(mesh.centre.z, -16) + std::ldexp(mesh.half_extent.z, -31) * p.z};
  Point world{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& row = transform.m[i];
    world[i] = std::ldexp(row[0], -16) * own[0] + std::ldexp(row[1], -16) * own[1] + std::ldexp(row[2], -16) * own[2] +
               std::ldexp(row[3], -16);
  }
  return world;
}

inline Facet facet_of(const zstrip::Mesh& mesh, const zstrip::Transform& transform, const zstrip::Triangle& t) {
  return {{placed(mesh, transform, t.a), placed(mesh, transform, t.b), placed(mesh, transform, t.c)}};
}

/// Where a ray's line meets a triangle, edges included.
inline std::optional<double> meets(const Facet& facet, const Ray& ray) {
  const Point a = facet.corner[1] - facet.corner[0], b = facet.corner[2] - facet.corner[0];
  const Point p = cross(ray.along, b);
  const double determinant = dot(a, p);
  if (determinant == 0) return {};
  const Point to = ray.from - facet.corner[0], q = cross(to, a);
  const double u = dot(to, p) / determinant, v = dot(ray.along, q) / determinant;
  if (u < 0 || v < 0 || u + v > 1) return {};
  return dot(b, q) / determinant;
}

}  // namespace oracle
