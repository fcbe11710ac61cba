// A scene's triangles in world space, in double precision, with their lit colours, to be sorted and split; and the
// conversion back to a scene.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "result.hpp"
#include "zstrip/scene.hpp"

namespace zstrip::sim {

struct SoupPoint {
  double x = 0, y = 0, z = 0;
};
double dot(const SoupPoint& a, const SoupPoint& b);
SoupPoint cross(const SoupPoint& a, const SoupPoint& b);
SoupPoint difference(const SoupPoint& a, const SoupPoint& b);

struct SoupCorner {
  SoupPoint position;
  std::array<double, 3> colour{};  ///< 0..255 a channel
};

/// A convex and flat polygon, counter-clockwise seen from the front.
using SoupPolygon = std::vector<SoupCorner>;

/// The plane of a polygon: distances are positive in front of it.
struct SoupPlane {
  SoupPoint normal;  ///< unit; 0 for a polygon without area
  double distance = 0;

  static SoupPlane of(const SoupPolygon& polygon);
  double at(const SoupPoint& p) const { return dot(normal, p) - distance; }
  bool degenerate() const { return dot(normal, normal) < 0.5; }
};

/// A point that is closer to a plane, in world units, lies in it.
inline constexpr double kOnPlane = 1e-6;

/// The parts of a polygon in front of a plane and behind it; empty if there is none.
struct SoupSplit {
  SoupPolygon front, back;
};
SoupSplit split(const SoupPolygon& polygon, const SoupPlane& plane);

struct PolygonSoup {
  std::vector<SoupPolygon> polygons;
  bool double_sided = false;
  bool smooth = false;
  Colour background{};
};

/// Returns a usage error for textures, which colours at corners cannot represent.
Result<PolygonSoup> soup_of(const Scene& scene);

/// One instance of one mesh, in meshlets, that owns its memory; triangles are in the order of the polygons. Views stay
/// valid when it is moved.
class SoupScene {
 public:
  /// Returns a usage error if there are more vertices than a mesh can have.
  static Result<SoupScene> of(const PolygonSoup& soup);

  Scene scene() const;
  const Mesh& mesh() const { return mesh_[0]; }
  /// Returns the number of triangles of the polygons before this one.
  std::size_t first_triangle(std::size_t polygon) const { return first_triangle_[polygon]; }

 private:
  std::vector<Position> positions_;
  std::vector<Colour> colours_;
  std::vector<Triangle> triangles_;
  std::vector<Meshlet> meshlets_;
  std::vector<std::size_t> first_triangle_;
  std::vector<Mesh> mesh_;
  std::vector<Material> material_;
  std::vector<Instance> instance_;
  Colour background_{};
};

}  // namespace zstrip::sim
