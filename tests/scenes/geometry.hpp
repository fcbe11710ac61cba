// Meshes in world units, in double precision: what the tests measure the integers with.
#pragma once

#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "zstrip/scene.hpp"

namespace zstrip::scenes_test {

struct Point {
  double x = 0, y = 0, z = 0;
  friend Point operator+(const Point& a, const Point& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Point operator-(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Point operator*(double s, const Point& a) { return {s * a.x, s * a.y, s * a.z}; }
};
inline double dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Point cross(const Point& a, const Point& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(const Point& a) { return std::sqrt(dot(a, a)); }

inline Point to_point(const Vec3& v, double one = 65536) { return {v.x / one, v.y / one, v.z / one}; }
inline Point to_point(float x, float y, float z) {
  return {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
}
inline Point to_point(const Normal& n) { return {n.x / 127.0, n.y / 127.0, n.z / 127.0}; }

inline Point object_position(const Mesh& mesh, const Position& p) {
  const Point half = to_point(mesh.half_extent), centre = to_point(mesh.centre);
  return centre + Point{half.x * p.x / 32768, half.y * p.y / 32768, half.z * p.z / 32768};
}

inline Point apply(const Transform& t, const Point& p) {
  const auto row = [&](int i) { return (t.m[i][0] * p.x + t.m[i][1] * p.y + t.m[i][2] * p.z + t.m[i][3]) / 65536; };
  return {row(0), row(1), row(2)};
}

/// The mesh's triangles with coincident vertices made one.
using WeldedTriangle = std::array<std::size_t, 3>;
inline std::vector<WeldedTriangle> welded(const Mesh& mesh) {
  std::map<std::array<int, 3>, std::size_t> index_of;
  const auto index = [&](std::uint16_t vertex) {
    const Position& p = mesh.positions[vertex];
    return index_of.try_emplace({p.x, p.y, p.z}, index_of.size()).first->second;
  };
  std::vector<WeldedTriangle> triangles;
  for (const Triangle& t : mesh.triangles) triangles.push_back({index(t.a), index(t.b), index(t.c)});
  return triangles;
}

/// Negative where front faces look inwards.
inline double signed_volume(const Mesh& mesh) {
  double six_volumes = 0;
  for (const Triangle& t : mesh.triangles) {
    six_volumes += dot(object_position(mesh, mesh.positions[t.a]),
                       cross(object_position(mesh, mesh.positions[t.b]), object_position(mesh, mesh.positions[t.c])));
  }
  return six_volumes / 6;
}

}  // namespace zstrip::scenes_test
