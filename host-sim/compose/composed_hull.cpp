// Joins equal vertices. Finds for each the normal v with v . n = 1 for the normals n of the faces around it, as the
// solution of least squares.
#include "compose/composed_hull.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <tuple>

#include "import/meshlets.hpp"
#include "import/quantise.hpp"
#include "motion/affine.hpp"

namespace zstrip::sim {
namespace {

using Place = std::tuple<std::int16_t, std::int16_t, std::int16_t>;

Place place_of(const Position& p) { return {p.x, p.y, p.z}; }
Vector less(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double length(const Vector& v) { return std::sqrt(scalar_product(v, v)); }

/// The faces around a vertex: sums of the normals and of their products, weighted by the angle of each face.
struct Corner {
  Vector sum{0, 0, 0};
  std::array<Vector, 3> products{};
  double weight = 0;

  void add(const Vector& normal, double angle) {
    for (std::size_t i = 0; i < 3; ++i) {
      sum[i] += angle * normal[i];
      for (std::size_t k = 0; k < 3; ++k) products[i][k] += angle * normal[i] * normal[k];
    }
    weight += angle;
  }
};

/// Solves v . n = 1 by least squares. A small weight for the mean direction determines components that no face
/// determines.
Vector mitre(const Corner& corner) {
  const double mean_length = length(corner.sum);
  if (!(mean_length > 1e-9)) return {0, 0, 0};  // faces back to back
  const double pull = 0.02 * corner.weight;
  std::array<Vector, 3> m = corner.products;
  Vector right = corner.sum;
  for (std::size_t i = 0; i < 3; ++i) {
    m[i][i] += pull;
    right[i] += pull * corner.sum[i] / mean_length;
  }
  const double determinant = scalar_product(m[0], vector_product(m[1], m[2]));  // symmetric: rows are columns
  return {scalar_product(right, vector_product(m[1], m[2])) / determinant,
          scalar_product(m[0], vector_product(right, m[2])) / determinant,
          scalar_product(m[0], vector_product(m[1], right)) / determinant};
}

/// Converts to 1.7; shortens the vector if a component would not fit.
Normal to_normal(const Vector& v) {
  const double largest = std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2]), 1.0});
  const auto component = [&](std::size_t axis) {
    return static_cast<std::int8_t>(std::lround(127 * v[axis] / largest));
  };
  return {component(0), component(1), component(2), 0};
}

}  // namespace

bool is_own_hull(const Mesh& mesh) {
  if (mesh.normals.empty()) return false;
  std::map<Place, Normal> known;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Normal& n = mesh.normals[i];
    const Normal& first = known.try_emplace(place_of(mesh.positions[i]), n).first->second;
    if (first.x != n.x || first.y != n.y || first.z != n.z) return false;
  }
  return true;
}

std::vector<MeshData> hull_of(const Mesh& mesh) {
  MeshData whole;
  std::map<Place, std::uint32_t> places;
  std::vector<std::uint32_t> vertex_at;
  for (const Position& p : mesh.positions) {
    const auto [at, is_new] = places.try_emplace(place_of(p), static_cast<std::uint32_t>(whole.positions.size()));
    if (is_new) whole.positions.push_back(p);
    vertex_at.push_back(at->second);
  }
  const auto point = [&](std::uint32_t vertex) {
    const Position& p = whole.positions[vertex];
    return Vector{from_fixed(mesh.half_extent.x) * p.x, from_fixed(mesh.half_extent.y) * p.y,
                  from_fixed(mesh.half_extent.z) * p.z};
  };
  std::vector<Corner> corners(whole.positions.size());
  std::vector<std::uint32_t> indices;
  for (const Triangle& t : mesh.triangles) {
    const std::array<std::uint32_t, 3> index{vertex_at[t.a], vertex_at[t.b], vertex_at[t.c]};
    const Vector face = vector_product(less(point(index[1]), point(index[0])), less(point(index[2]), point(index[0])));
    const double area = length(face);
    if (!(area > 0)) continue;
    indices.insert(indices.end(), index.begin(), index.end());
    const Vector normal{face[0] / area, face[1] / area, face[2] / area};
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector to_next = less(point(index[(i + 1) % 3]), point(index[i]));
      const Vector to_last = less(point(index[(i + 2) % 3]), point(index[i]));
      corners[index[i]].add(normal, std::atan2(area, scalar_product(to_next, to_last)));
    }
  }
  for (const Corner& corner : corners) whole.normals.push_back(to_normal(mitre(corner)));
  return split_into_meshlets(whole, indices, mesh.half_extent);
}

}  // namespace zstrip::sim
