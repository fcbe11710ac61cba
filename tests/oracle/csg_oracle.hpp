// What is seen of CSG at a point of the picture, by rays in double precision against every triangle:
// where a ray enters and leaves each operand, and the first place where it comes into a product from outside. Shares
// nothing with the renderer but the scene.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "rays.hpp"

namespace oracle {

class CsgOracle {
 public:
  CsgOracle(const zstrip::Scene& scene, const zstrip::Camera& camera, const zstrip::View& view)
      : scene_(scene), camera_(camera), view_(view) {
    for (const zstrip::Instance& instance : scene.instances) {
      const zstrip::Mesh& mesh = scene.meshes[instance.mesh];
      std::vector<Facet> facets;
      for (const zstrip::Triangle& t : mesh.triangles) {
        facets.push_back(facet_of(mesh, instance.transform, t));
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
    const Ray ray = ray_through(camera_, view_, x, y);
    std::vector<std::vector<Crossing>> crossings;
    for (const std::vector<Facet>& facets : solids_) crossings.push_back(crossings_of(facets, ray));
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

  static std::vector<Crossing> crossings_of(const std::vector<Facet>& facets, const Ray& ray) {
    std::vector<Crossing> found;
    for (const Facet& facet : facets) {
      if (const std::optional<double> distance = meets(facet, ray)) {
        found.push_back({*distance, dot(facet.normal(), ray.along) < 0});
      }
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

  const zstrip::Scene& scene_;
  zstrip::Camera camera_;
  zstrip::View view_;
  std::vector<std::vector<Facet>> solids_;
};

}  // namespace oracle
