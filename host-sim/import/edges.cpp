// The edges of a mesh: see edges.hpp.
#include "import/edges.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "import/quantise.hpp"
#include "motion/affine.hpp"

namespace zstrip::sim {
namespace {

/// A triangle's side, in the direction around the triangle.
struct Side {
  std::uint16_t a, b, third;
  std::uint32_t triangle;
  std::uint64_t low, high;  ///< its two places, in an order
  bool forwards;            ///< the direction is from `low` to `high`
};

class EdgeFinder {
 public:
  EdgeFinder(const Mesh& mesh, bool flat) : mesh_(mesh), flat_(flat) {}

  std::vector<Edge> find() const {
    std::vector<Side> sides = all_sides();
    std::ranges::sort(sides, {}, [](const Side& s) { return std::tuple(s.low, s.high, s.triangle); });
    // Each edge is stored with the triangle of a, b and left, so that the order of the meshlets can be restored.
    std::vector<std::pair<std::uint32_t, Edge>> found;
    const auto add = [&found](const Side& side, std::uint16_t right) {
      found.emplace_back(side.triangle, Edge{side.a, side.b, side.third, right});
    };
    for (std::size_t first = 0, end = 0; first < sides.size(); first = end) {
      while (end < sides.size() && sides[end].low == sides[first].low && sides[end].high == sides[first].high) ++end;
      const Side& side = sides[first];
      if (end - first == 2 && side.forwards != sides[first + 1].forwards) {
        const Side& other = sides[first + 1];
        // The direction of an edge says if it is a crease.
        Edge edge{side.a, side.b, side.third, other.third};
        if ((edge.a > edge.b) != is_crease(side, other)) edge = {edge.b, edge.a, edge.right, edge.left};
        found.emplace_back(side.triangle, edge);
      } else {
        for (std::size_t i = first; i < end; ++i) add(sides[i], kNoFace);
      }
    }
    std::ranges::stable_sort(found, {}, &std::pair<std::uint32_t, Edge>::first);
    std::vector<Edge> edges;
    for (const auto& [triangle, edge] : found) edges.push_back(edge);
    return edges;
  }

 private:
  std::uint64_t place(std::uint16_t vertex) const {
    const Position& p = mesh_.positions[vertex];
    const auto part = [](std::int16_t value) { return static_cast<std::uint64_t>(value + 32768); };
    return part(p.x) << 32 | part(p.y) << 16 | part(p.z);
  }

  std::vector<Side> all_sides() const {
    std::vector<Side> sides;
    for (std::uint32_t i = 0; i < mesh_.triangles.size(); ++i) {
      const Triangle& t = mesh_.triangles[i];
      if (!normal(i)) continue;
      for (const auto& [a, b, c] : {std::array{t.a, t.b, t.c}, {t.b, t.c, t.a}, {t.c, t.a, t.b}}) {
        const std::uint64_t from = place(a), to = place(b);
        sides.push_back({a, b, c, i, std::min(from, to), std::max(from, to), from < to});
      }
    }
    return sides;
  }

  /// Returns a normal of length 1; nothing for a triangle without an area.
  std::optional<Vector> normal(std::uint32_t triangle) const {
    const Triangle& t = mesh_.triangles[triangle];
    const auto side = [&](std::uint16_t from, std::uint16_t to) {
      const Position &p = mesh_.positions[from], &q = mesh_.positions[to];
      const Vec3& half = mesh_.half_extent;
      return Vector{(q.x - p.x) * from_fixed(half.x), (q.y - p.y) * from_fixed(half.y),
                    (q.z - p.z) * from_fixed(half.z)};
    };
    const Vector u = side(t.a, t.b), v = side(t.a, t.c);
    const Vector n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    const double length = std::hypot(n[0], n[1], n[2]);
    if (!(length > 0)) return std::nullopt;
    return Vector{n[0] / length, n[1] / length, n[2] / length};
  }

  bool looks_different(std::uint16_t one, std::uint16_t other) const {
    if (one == other) return false;
    if (!mesh_.normals.empty()) {
      const Normal &a = mesh_.normals[one], &b = mesh_.normals[other];
      if (a.x != b.x || a.y != b.y || a.z != b.z) return true;
    }
    return !mesh_.colours.empty() && mesh_.colours[one] != mesh_.colours[other];
  }

  bool is_crease(const Side& one, const Side& other) const {
    if (looks_different(one.a, other.b) || looks_different(one.b, other.a)) return true;
    if (!flat_) return false;
    const Vector a = *normal(one.triangle), b = *normal(other.triangle);
    constexpr double kCosineOfOneDegree = 0.99985;
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] < kCosineOfOneDegree;
  }

  const Mesh& mesh_;
  bool flat_;
};

}  // namespace

std::vector<Edge> find_edges(const Mesh& mesh, bool flat) { return EdgeFinder(mesh, flat).find(); }

SceneEdges find_edges(const Scene& scene, std::span<const DetailLevel> levels) {
  std::map<std::uint16_t, bool> meshes;
  for (const Instance& instance : scene.instances) {
    meshes[instance.mesh] |= scene.materials[instance.material].smooth == Shading::flat;
  }
  for (const DetailLevel& level : levels) meshes[level.coarser] = meshes[level.mesh];
  SceneEdges found;
  for (const auto& [mesh, flat] : meshes) {
    std::vector<Edge> edges = find_edges(scene.meshes[mesh], flat);
    if (edges.empty()) continue;
    found.lists.push_back(std::move(edges));
    found.sets.push_back({found.lists.back(), mesh});
  }
  return found;
}

}  // namespace zstrip::sim
