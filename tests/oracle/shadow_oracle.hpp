// Which pixels of a picture lie in a light's shadow, by rays in double precision against every triangle and ellipsoid:
// from the eye to the surface, and from there to the light. Shares nothing with the renderer but the scene.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "zstrip/scene/camera.hpp"
#include "zstrip/scene/scene.hpp"
#include "zstrip/scene/view.hpp"

namespace oracle {

using Point = std::array<double, 3>;
inline Point operator+(const Point& a, const Point& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Point operator-(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Point operator*(double s, const Point& p) { return {s * p[0], s * p[1], s * p[2]}; }
inline double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Point unit(const Point& a) { return 1 / std::sqrt(dot(a, a)) * a; }

struct Facet {
  Point corner[3];
  bool casts, receives, double_sided;
  Point normal() const { return cross(corner[1] - corner[0], corner[2] - corner[0]); }
};

/// |inverse (p - centre)| = 1.
struct Ball {
  Point centre, inverse_rows[3];
  Point inside(const Point& p) const {
    return {dot(inverse_rows[0], p), dot(inverse_rows[1], p), dot(inverse_rows[2], p)};
  }
};

struct Surface {
  Point at, normal;  ///< any length; towards the eye
  bool receives;
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

class ShadowOracle {
 public:
  ShadowOracle(const zstrip::Scene& scene, const zstrip::Camera& camera, const zstrip::View& view)
      : camera_(camera), view_(view) {
    const zstrip::DirectionalLight& light = scene.lights[scene.shadow->light];
    towards_ = unit({light.x / 32767.0, light.y / 32767.0, light.z / 32767.0});
    for (const zstrip::Instance& instance : scene.instances) {
      const zstrip::Mesh& mesh = scene.meshes[instance.mesh];
      for (const zstrip::Triangle& t : mesh.triangles) {
        facets_.push_back(
            {{placed(mesh, instance.transform, t.a), placed(mesh, instance.transform, t.b),
              placed(mesh, instance.transform, t.c)},
             mesh.shadow == zstrip::ShadowRole::casts_and_receives || mesh.shadow == zstrip::ShadowRole::only_casts,
             mesh.shadow == zstrip::ShadowRole::casts_and_receives || mesh.shadow == zstrip::ShadowRole::only_receives,
             scene.materials[instance.material].double_sided});
      }
    }
    for (const zstrip::Quadric& quadric : scene.quadrics) balls_.push_back(ball(quadric.transform));
  }

  const Point& towards_light() const { return towards_; }

  /// What the middle of a pixel shows; nothing where that is the background.
  std::optional<Surface> seen(int x, int y) const {
    const double focal = std::ldexp(camera_.focal, -16) * view_.height / 2;
    const double across = (x + 0.5 - view_.width / 2.0) / focal, down = (y + 0.5 - view_.height / 2.0) / focal;
    const Point right = axis(camera_.right), up = axis(camera_.up), back = axis(camera_.back);
    Point from{std::ldexp(camera_.eye.x, -16), std::ldexp(camera_.eye.y, -16), std::ldexp(camera_.eye.z, -16)};
    Point along = -1.0 * back;
    if (camera_.projection == zstrip::Projection::orthographic) {
      from = from + across * right - down * up;
    } else {
      along = along + across * right - down * up;
    }
    std::optional<Surface> nearest;
    double best = 1e30;
    for (const Facet& facet : facets_) {
      const Point n = facet.normal();
      const double facing = dot(n, along);
      if (facing >= 0 && !facet.double_sided) continue;
      const std::optional<double> t = meets(facet, from, along);
      if (!t || *t <= std::ldexp(camera_.near_plane, -16) || *t >= best) continue;
      best = *t;
      nearest = Surface{from + best * along, facing < 0 ? n : -1.0 * n, facet.receives};
    }
    for (const Ball& one : balls_) {
      const std::optional<double> t = meets(one, from, along, -1);
      if (!t || *t <= std::ldexp(camera_.near_plane, -16) || *t >= best) continue;
      best = *t;
      const Point p = from + best * along, q = one.inside(p - one.centre);
      const Point n = q[0] * one.inverse_rows[0] + q[1] * one.inverse_rows[1] + q[2] * one.inverse_rows[2];
      nearest = Surface{p, n, true};
    }
    return nearest;
  }

  /// Whether something lies between a point and the light, more than `slack` away from it.
  bool shadowed(const Point& at, double slack) const {
    const Point from = at + slack * towards_;
    for (const Facet& facet : facets_) {
      if (!facet.casts) continue;
      const std::optional<double> t = meets(facet, from, towards_);
      if (t && *t > 0) return true;
    }
    for (const Ball& one : balls_) {
      const std::optional<double> t = meets(one, from, towards_, 1);
      if (t && *t > 0) return true;
    }
    return false;
  }

  /// Whether all of the surface's plane around a point, as far as `reach` seen from the light, is in shadow or not as
  /// the point is.
  bool is_far_from_edge(const Surface& surface, double reach, double slack) const {
    const Point n = unit(surface.normal);
    const double facing = dot(n, towards_);
    const bool here = shadowed(surface.at, slack);
    if (std::abs(facing) < 1e-6) return false;
    Point across = unit(cross(towards_, std::abs(towards_[0]) < 0.9 ? Point{1, 0, 0} : Point{0, 1, 0}));
    const Point along = cross(towards_, across);
    for (int ring = 1; ring <= 2; ++ring) {
      for (int step = 0; step < 16; ++step) {
        const double angle = step * 3.14159265358979 / 8, r = reach * ring / 2;
        const Point beside = r * std::cos(angle) * across + r * std::sin(angle) * along;
        if (shadowed(surface.at + beside - dot(n, beside) / facing * towards_, slack) != here) return false;
      }
    }
    return true;
  }

 private:
  static Point axis(const zstrip::Vec3& v) {
    return {std::ldexp(v.x, -30), std::ldexp(v.y, -30), std::ldexp(v.z, -30)};
  }

  static Ball ball(const zstrip::Transform& transform) {
    Point column[3];
    Ball one{};
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t r = 0; r < 3; ++r) column[c][r] = std::ldexp(transform.m[r][c], -16);
    }
    for (std::size_t r = 0; r < 3; ++r) one.centre[r] = std::ldexp(transform.m[r][3], -16);
    const double volume = dot(column[0], cross(column[1], column[2]));
    for (std::size_t i = 0; i < 3; ++i) {
      one.inverse_rows[i] = 1 / volume * cross(column[(i + 1) % 3], column[(i + 2) % 3]);
    }
    return one;
  }

  /// Where a line meets a triangle, edges included.
  static std::optional<double> meets(const Facet& facet, const Point& from, const Point& along) {
    const Point a = facet.corner[1] - facet.corner[0], b = facet.corner[2] - facet.corner[0];
    const Point p = cross(along, b);
    const double determinant = dot(a, p);
    if (determinant == 0) return {};
    const Point to = from - facet.corner[0], q = cross(to, a);
    const double u = dot(to, p) / determinant, v = dot(along, q) / determinant;
    if (u < 0 || v < 0 || u + v > 1) return {};
    return dot(b, q) / determinant;
  }

  /// The nearer place (-1) or the farther one (1) in which a line meets an ellipsoid.
  static std::optional<double> meets(const Ball& one, const Point& from, const Point& along, int which) {
    const Point o = one.inside(from - one.centre), d = one.inside(along);
    const double a = dot(d, d), b = dot(o, d), c = dot(o, o) - 1;
    const double root = b * b - a * c;
    if (root < 0) return {};
    return (-b + which * std::sqrt(root)) / a;
  }

  zstrip::Camera camera_;
  zstrip::View view_;
  Point towards_{};
  std::vector<Facet> facets_;
  std::vector<Ball> balls_;
};

}  // namespace oracle
