// What is seen of products of solids at a point of the picture, by rays in double precision against every triangle:
// where a ray enters and leaves each operand, and the first place where it comes into a product from outside. Shares
// nothing with the renderer but the scene.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "shadow_oracle.hpp"

namespace oracle {

class CsgOracle {
 public:
  CsgOracle(const zstrip::Scene& scene, const zstrip::Camera& camera, const zstrip::View& view)
      : scene_(scene), camera_(camera), view_(view) {
    for (const zstrip::Instance& instance : scene.instances) {
      const zstrip::Mesh& mesh = scene.meshes[instance.mesh];
      std::vector<Facet> facets;
      for (const zstrip::Triangle& t : mesh.triangles) {
        const auto corner = [&](std::uint16_t index) { return placed(mesh, instance.transform, index); };
        facets.push_back({{corner(t.a), corner(t.b), corner(t.c)}, false, false, false});
      }
      solids_.push_back(facets);
    }
  }

  struct Seen {
    std::size_t instance;
    double distance;   ///< along the viewing direction
    double clearance;  ///< from there to the next face of anything, along the viewing direction
    friend bool operator==(const Seen& a, const Seen& b) { return a.instance == b.instance; }
  };

  /// At (x, y) pixels; nothing where that is the background. Instances that are no operands are products by themselves.
  std::optional<Seen> seen(double x, double y) const {
    const double focal = std::ldexp(camera_.focal, -16) * view_.height / 2;
    const double across = (x - view_.width / 2.0) / focal, down = (y - view_.height / 2.0) / focal;
    const Point right = axis(camera_.right), up = axis(camera_.up), back = axis(camera_.back);
    Point from{std::ldexp(camera_.eye.x, -16), std::ldexp(camera_.eye.y, -16), std::ldexp(camera_.eye.z, -16)};
    Point along = -1.0 * back;
    if (camera_.projection == zstrip::Projection::orthographic) {
      from = from + across * right - down * up;
    } else {
      along = along + across * right - down * up;
    }
    std::vector<std::vector<Crossing>> crossings;
    for (const std::vector<Facet>& facets : solids_) crossings.push_back(crossings_of(facets, from, along));
    std::optional<Seen> nearest;
    const auto consider = [&](std::size_t instance, double distance) {
      if (distance > std::ldexp(camera_.near_plane, -16) && distance < std::ldexp(camera_.far_plane, -16) &&
          (!nearest || distance < nearest->distance)) {
        nearest = Seen{instance, distance, 1e30};
      }
    };
    for (std::size_t first = 0, end = 0; first < scene_.csg.size(); first = end) {
      while (end < scene_.csg.size() && scene_.csg[end].product == scene_.csg[first].product) ++end;
      const std::span operands = scene_.csg.subspan(first, end - first);
      for (const zstrip::CsgOperand& operand : operands) {
        for (const Crossing& crossing : crossings[operand.instance]) {
          if (!is_in(operands, crossings, crossing.distance, true) ||
              is_in(operands, crossings, crossing.distance, false))
            continue;
          consider(operand.instance, crossing.distance);
        }
      }
    }
    for (std::size_t i = 0; i < solids_.size(); ++i) {
      if (std::any_of(scene_.csg.begin(), scene_.csg.end(), [i](const auto& operand) { return operand.instance == i; }))
        continue;
      for (const Crossing& crossing : crossings[i]) {
        if (crossing.enters) consider(i, crossing.distance);
      }
    }
    if (nearest) {
      int themselves = 0;
      for (const auto& of_solid : crossings) {
        for (const Crossing& crossing : of_solid) {
          const double apart = std::abs(crossing.distance - nearest->distance);
          if (apart == 0 && themselves++ == 0) continue;
          nearest->clearance = std::min(nearest->clearance, apart);
        }
      }
    }
    return nearest;
  }

 private:
  struct Crossing {
    double distance;
    bool enters;
  };

  static std::vector<Crossing> crossings_of(const std::vector<Facet>& facets, const Point& from, const Point& along) {
    std::vector<Crossing> found;
    for (const Facet& facet : facets) {
      const Point a = facet.corner[1] - facet.corner[0], b = facet.corner[2] - facet.corner[0];
      const Point p = cross(along, b);
      const double determinant = dot(a, p);
      if (determinant == 0) continue;
      const Point to = from - facet.corner[0], q = cross(to, a);
      const double u = dot(to, p) / determinant, v = dot(along, q) / determinant;
      if (u < 0 || v < 0 || u + v > 1) continue;
      found.push_back({dot(b, q) / determinant, dot(facet.normal(), along) < 0});
    }
    return found;
  }

  /// Whether the points just behind, or just before, a place on the ray are in all intersected and no subtracted solid.
  static bool is_in(std::span<const zstrip::CsgOperand> operands, const std::vector<std::vector<Crossing>>& crossings,
                    double distance, bool behind) {
    for (const zstrip::CsgOperand& operand : operands) {
      int around = 0;
      for (const Crossing& crossing : crossings[operand.instance]) {
        if (crossing.distance < distance || (behind && crossing.distance == distance))
          around += crossing.enters ? 1 : -1;
      }
      if ((around > 0) != (operand.use == zstrip::CsgUse::intersected)) return false;
    }
    return true;
  }

  static Point axis(const zstrip::Vec3& v) {
    return {std::ldexp(v.x, -30), std::ldexp(v.y, -30), std::ldexp(v.z, -30)};
  }

  const zstrip::Scene& scene_;
  zstrip::Camera camera_;
  zstrip::View view_;
  std::vector<std::vector<Facet>> solids_;
};

}  // namespace oracle
