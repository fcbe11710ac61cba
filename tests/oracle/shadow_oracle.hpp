// Which pixels of a picture lie in a light's shadow, by rays in double precision against every triangle and ellipsoid:
// from the eye to the surface, and from there to the light. Shares nothing with the renderer but the scene.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "rays.hpp"

namespace oracle {

struct ShadowFacet : Facet {
  bool casts, receives, double_sided;
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
            {facet_of(mesh, instance.transform, t),
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
    const Ray ray = ray_through(camera_, view_, x + 0.5, y + 0.5);
    std::optional<Surface> nearest;
    double best = 1e30;
    for (const ShadowFacet& facet : facets_) {
      const Point n = facet.normal();
      const double facing = dot(n, ray.along);
      if (facing >= 0 && !facet.double_sided) continue;
      const std::optional<double> t = meets(facet, ray);
      if (!t || *t <= std::ldexp(camera_.near_plane, -16) || *t >= best) continue;
      best = *t;
      nearest = Surface{ray.at(best), facing < 0 ? n : -1.0 * n, facet.receives};
    }
    for (const Ball& one : balls_) {
      const std::optional<double> t = meets_ball(one, ray, -1);
      if (!t || *t <= std::ldexp(camera_.near_plane, -16) || *t >= best) continue;
      best = *t;
      const Point p = ray.at(best), q = one.inside(p - one.centre);
      const Point n = q[0] * one.inverse_rows[0] + q[1] * one.inverse_rows[1] + q[2] * one.inverse_rows[2];
      nearest = Surface{p, n, true};
    }
    return nearest;
  }

  /// Whether something lies between a point and the light, more than `slack` away from it.
  bool shadowed(const Point& at, double slack) const {
    const Ray ray{at + slack * towards_, towards_};
    for (const ShadowFacet& facet : facets_) {
      if (!facet.casts) continue;
      const std::optional<double> t = meets(facet, ray);
      if (t && *t > 0) return true;
    }
    for (const Ball& one : balls_) {
      const std::optional<double> t = meets_ball(one, ray, 1);
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

  /// The nearer place (-1) or the farther one (1) in which a ray's line meets an ellipsoid.
  static std::optional<double> meets_ball(const Ball& one, const Ray& ray, int which) {
    const Point o = one.inside(ray.from - one.centre), d = one.inside(ray.along);
    const double a = dot(d, d), b = dot(o, d), c = dot(o, o) - 1;
    const double root = b * b - a * c;
    if (root < 0) return {};
    return (-b + which * std::sqrt(root)) / a;
  }

  zstrip::Camera camera_;
  zstrip::View view_;
  Point towards_{};
  std::vector<ShadowFacet> facets_;
  std::vector<Ball> balls_;
};

}  // namespace oracle
