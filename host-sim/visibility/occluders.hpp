// Opaque triangles of a scene, grouped by plane, such as a wall.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "visibility/polygon_soup.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::sim {

struct PlanePoint {
  double x, y;
};

/// Triangles in one plane that hide everything behind the plane from all points in front of it.
class Occluder {
 public:
  explicit Occluder(const SoupPlane& plane);

  const SoupPlane& plane() const { return plane_; }
  double area() const { return area_; }
  PlanePoint projected(const SoupPoint& point) const { return {dot(across_, point), dot(up_, point)}; }
  /// Adds a triangle in the plane, counter-clockwise seen from its front.
  void add(const std::array<SoupPoint, 3>& corners);
  /// Returns false if the point, in the plane's coordinates, is certainly in none of the triangles.
  bool may_cover(const PlanePoint& p) const {
    return p.x >= low_.x && p.x <= high_.x && p.y >= low_.y && p.y <= high_.y;
  }
  /// True if the triangles together cover the convex hull of `points`, in the plane's coordinates. Also false if the
  /// test would need more than a few hundred pieces.
  bool cover(std::vector<PlanePoint> points) const;

 private:
  SoupPlane plane_;
  SoupPoint across_, up_;  ///< unit vectors in the plane
  double area_ = 0;
  std::vector<std::array<PlanePoint, 3>> triangles_;
  PlanePoint low_{1e300, 1e300}, high_{-1e300, -1e300};
};

/// Returns a corner of a mesh in world space.
SoupPoint world_position(const Mesh& mesh, const Transform& transform, const Position& position);

/// Returns the occluders of instances that do not move (`moves`: one for each instance), with materials that hide
/// surfaces behind them; the largest first, at most `most`.
std::vector<Occluder> occluders_of(const Scene& scene, const std::vector<bool>& moves, std::size_t most);

}  // namespace zstrip::sim
