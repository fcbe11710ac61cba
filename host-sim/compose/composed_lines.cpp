// Lines and points of a composed scene; see composed_lines.hpp.
#include "compose/composed_lines.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "import/quantise.hpp"

namespace zstrip::sim {
namespace {

/// Returns, for each vertex, the first vertex in the same place.
std::vector<std::uint16_t> first_in_place(const Mesh& mesh) {
  std::map<std::tuple<std::int16_t, std::int16_t, std::int16_t>, std::uint16_t> places;
  std::vector<std::uint16_t> first;
  for (const Position& p : mesh.positions) {
    first.push_back(places.try_emplace({p.x, p.y, p.z}, static_cast<std::uint16_t>(first.size())).first->second);
  }
  return first;
}

}  // namespace

std::vector<Segment> edges_of(const Mesh& mesh) {
  const std::vector<std::uint16_t> first = first_in_place(mesh);
  std::set<std::pair<std::uint16_t, std::uint16_t>> known;
  std::vector<Segment> edges;
  for (const Triangle& t : mesh.triangles) {
    for (const auto& [from, to] : {std::pair{t.a, t.b}, std::pair{t.b, t.c}, std::pair{t.c, t.a}}) {
      const auto [low, high] = std::minmax(first[from], first[to]);
      if (low != high && known.insert({low, high}).second) edges.push_back({low, high});
    }
  }
  return edges;
}

std::vector<Segment> points_of(const Mesh& mesh) {
  const std::vector<std::uint16_t> first = first_in_place(mesh);
  std::vector<Segment> points;
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (first[i] == i) points.push_back({first[i], first[i]});
  }
  return points;
}

Mesh mesh_of(std::span<const Vector> vertices, MeshData& own) {
  Vector low = vertices.front(), high = low;
  for (const Vector& vertex : vertices) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], vertex[axis]);
      high[axis] = std::max(high[axis], vertex[axis]);
    }
  }
  Mesh mesh;
  Fixed* const centre[3] = {&mesh.centre.x, &mesh.centre.y, &mesh.centre.z};
  Fixed* const half[3] = {&mesh.half_extent.x, &mesh.half_extent.y, &mesh.half_extent.z};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    *centre[axis] = to_fixed((low[axis] + high[axis]) / 2);
    *half[axis] = to_fixed((high[axis] - low[axis]) / 2) + 2;  // all vertices are inside after rounding
  }
  for (const Vector& vertex : vertices) {
    const auto coordinate = [&](std::size_t axis) {
      const double from_centre = vertex[axis] - from_fixed(*centre[axis]);
      return static_cast<std::int16_t>(
          std::clamp(std::lround(from_centre / from_fixed(*half[axis]) * 32768), -32767L, 32767L));
    };
    own.positions.push_back({coordinate(0), coordinate(1), coordinate(2)});
  }
  mesh.positions = own.positions;
  return mesh;
}

}  // namespace zstrip::sim
