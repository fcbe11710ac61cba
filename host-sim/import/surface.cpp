// Properties of a model's surface across meshes: corners that meet, closed parts, missing normals.
#include "import/surface.hpp"

#include <meshoptimizer.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <span>

#include "motion/affine.hpp"

namespace zstrip::sim {
namespace {

Vector difference(const std::array<float, 3>& a, const std::array<float, 3>& b) {
  return {double{a[0]} - double{b[0]}, double{a[1]} - double{b[1]}, double{a[2]} - double{b[2]}};
}
Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double length(const Vector& v) { return std::hypot(v[0], v[1], v[2]); }
bool is_zero(const std::array<float, 3>& v) { return v == std::array<float, 3>{}; }

/// The corners of all triangles of all meshes, in order, as numbers of positions. Equal positions have equal numbers.
struct Corners {
  std::vector<std::uint32_t> position;  ///< three a triangle
  std::uint32_t positions = 0;          ///< number of different positions
};

Corners join_positions(const SourceModel& model) {
  std::vector<std::array<float, 3>> points;
  for (const SourceMesh& mesh : model.meshes) {
    for (const std::uint32_t index : mesh.indices) points.push_back(mesh.vertices[index].position);
  }
  Corners corners{std::vector<std::uint32_t>(points.size()), 0};
  corners.positions = static_cast<std::uint32_t>(
      meshopt_generateVertexRemap(corners.position.data(), static_cast<const unsigned*>(nullptr), points.size(),
                                  points.data(), points.size(), sizeof points[0]));
  return corners;
}

/// Disjoint sets of numbers (union-find with path halving).
class Sets {
 public:
  explicit Sets(std::uint32_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0U); }
  std::uint32_t of(std::uint32_t number) {
    while (parent_[number] != number) number = parent_[number] = parent_[parent_[number]];
    return number;
  }
  void join(std::uint32_t one, std::uint32_t other) { parent_[of(one)] = of(other); }

 private:
  std::vector<std::uint32_t> parent_;
};

/// The corners at each position.
struct Fans {
  std::vector<std::uint32_t> first;  ///< index into `corner`; one more entry than positions
  std::vector<std::uint32_t> corner;
};

Fans collect_fans(const Corners& corners) {
  Fans fans{std::vector<std::uint32_t>(std::size_t{corners.positions} + 1), {}};
  for (const std::uint32_t position : corners.position) ++fans.first[position + 1];
  std::partial_sum(fans.first.begin(), fans.first.end(), fans.first.begin());
  fans.corner.resize(corners.position.size());
  std::vector<std::uint32_t> next(fans.first.begin(), fans.first.end() - 1);
  for (std::uint32_t corner = 0; corner < corners.position.size(); ++corner) {
    fans.corner[next[corners.position[corner]]++] = corner;
  }
  return fans;
}

/// With more faces at one point, creases there are ignored, because each face is compared with each other face.
constexpr std::size_t kMaxCreasedFan = 256;

/// Returns zero if the faces cancel each other. Without creases the normal is the same for all corners of the fan.
Vector smooth_normal(std::uint32_t corner, std::span<const std::uint32_t> fan, const std::vector<Vector>& face_normals,
                     const std::vector<double>& angles) {
  static const double least_cosine = std::cos(kCreaseAngle * std::numbers::pi / 180);
  const Vector& own = face_normals[corner / 3];
  const bool creased = fan.size() <= kMaxCreasedFan;
  Vector sum{};
  for (const std::uint32_t other : fan) {
    const Vector& normal = face_normals[other / 3];
    if (creased && scalar_product(own, normal) < least_cosine) continue;
    for (std::size_t i = 0; i < 3; ++i) sum[i] += angles[other] * normal[i];
  }
  return unit(sum);
}

}  // namespace

void generate_missing_normals(SourceModel& model) {
  const auto lacks_normals = [](const SourceMesh& mesh) {
    return std::any_of(mesh.indices.begin(), mesh.indices.end(),
                       [&](std::uint32_t index) { return is_zero(mesh.vertices[index].normal); });
  };
  if (std::none_of(model.meshes.begin(), model.meshes.end(), lacks_normals)) return;

  const Corners corners = join_positions(model);
  const Fans fans = collect_fans(corners);
  std::vector<Vector> face_normals;
  std::vector<double> angles;  // at each corner, radians
  for (const SourceMesh& mesh : model.meshes) {
    for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
      const auto corner = [&](std::size_t k) -> const auto& { return mesh.vertices[mesh.indices[t + k % 3]].position; };
      face_normals.push_back(
          unit(vector_product(unit(difference(corner(1), corner(0))), unit(difference(corner(2), corner(0))))));
      for (std::size_t k = 0; k < 3; ++k) {
        const Vector ahead = unit(difference(corner(k + 1), corner(k)));
        const Vector back = unit(difference(corner(k + 2), corner(k)));
        angles.push_back(std::acos(std::clamp(scalar_product(ahead, back), -1.0, 1.0)));
      }
    }
  }

  std::map<std::uint32_t, Vector> large_fans;  // by position
  std::uint32_t corner = 0;
  for (SourceMesh& mesh : model.meshes) {
    if (!lacks_normals(mesh)) {
      corner += static_cast<std::uint32_t>(mesh.indices.size());
      continue;
    }
    std::vector<SourceVertex> own;
    own.reserve(mesh.indices.size());
    for (const std::uint32_t index : mesh.indices) {
      SourceVertex vertex = mesh.vertices[index];
      if (is_zero(vertex.normal)) {
        const std::uint32_t position = corners.position[corner];
        const std::span fan(fans.corner.data() + fans.first[position], fans.first[position + 1] - fans.first[position]);
        Vector normal{};
        if (fan.size() <= kMaxCreasedFan) {
          normal = smooth_normal(corner, fan, face_normals, angles);
        } else {
          const auto [known, is_new] = large_fans.try_emplace(position);
          if (is_new) known->second = smooth_normal(corner, fan, face_normals, angles);
          normal = known->second;
        }
        if (!(length(normal) > 0)) normal = face_normals[corner / 3];
        for (std::size_t i = 0; i < 3; ++i) vertex.normal[i] = static_cast<float>(normal[i]) + 0.0F;
      }
      own.push_back(vertex);
      ++corner;
    }
    mesh.vertices = std::move(own);
    std::iota(mesh.indices.begin(), mesh.indices.end(), 0U);
  }
}

std::vector<Outside> find_outsides(const SourceModel& model) {
  if (model.meshes.empty()) return {};
  const Corners corners = join_positions(model);
  const std::size_t triangles = corners.position.size() / 3;

  // Bodies: positions that triangles connect.
  Sets bodies(corners.positions);
  for (std::size_t t = 0; t < triangles; ++t) {
    for (std::size_t k = 1; k < 3; ++k) bodies.join(corners.position[3 * t + k], corners.position[3 * t]);
  }

  struct Edge {
    std::uint32_t low, high;
    int direction;  // +1 from low to high
  };
  std::vector<Edge> edges;
  edges.reserve(corners.position.size());
  std::vector<Vector> place(corners.positions);   // relative to one vertex of the model
  std::vector<double> volume(corners.positions);  // six times the signed volume of a body
  std::vector<double> area(corners.positions);    // twice the area of a body
  std::size_t t = 0;
  const std::array<float, 3> origin = model.meshes[0].vertices[model.meshes[0].indices[0]].position;
  for (const SourceMesh& mesh : model.meshes) {
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3, ++t) {
      const std::uint32_t* at = &corners.position[3 * t];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t from = at[k];
        const std::uint32_t to = at[(k + 1) % 3];
        edges.push_back({std::min(from, to), std::max(from, to), from < to ? 1 : -1});
        place[from] = difference(mesh.vertices[mesh.indices[i + k]].position, origin);
      }
      const Vector &a = place[at[0]], &b = place[at[1]], &c = place[at[2]];
      volume[bodies.of(at[0])] += scalar_product(a, vector_product(b, c));
      area[bodies.of(at[0])] += length(vector_product(minus(b, a), minus(c, a)));
    }
  }
  std::sort(edges.begin(), edges.end(),
            [](const Edge& a, const Edge& b) { return a.low != b.low ? a.low < b.low : a.high < b.high; });
  std::vector<bool> is_open(corners.positions);  // by body
  std::vector<Edge> rims;                        // edges with more uses in one direction; `direction` is the difference
  for (std::size_t i = 0; i < edges.size();) {
    int balance = 0;
    const Edge& edge = edges[i];
    for (; i < edges.size() && edges[i].low == edge.low && edges[i].high == edge.high; ++i)
      balance += edges[i].direction;
    if (balance == 0) continue;
    is_open[bodies.of(edge.low)] = true;
    rims.push_back({edge.low, edge.high, balance});
  }

  // The area of an opening is half the sum of a x b along its rim. The rims at both ends of a tube count as two
  // openings.
  Sets openings(corners.positions);
  for (const Edge& edge : rims) openings.join(edge.low, edge.high);
  std::map<std::uint32_t, Vector> enclosed;
  for (const Edge& edge : rims) {
    Vector& sum = enclosed[openings.of(edge.low)];
    const Vector across = vector_product(place[edge.low], place[edge.high]);
    for (std::size_t k = 0; k < 3; ++k) sum[k] += edge.direction * across[k];
  }
  std::vector<double> opening(corners.positions);  // twice the area of all openings of a body
  for (const auto& [rim, sum] : enclosed) opening[bodies.of(rim)] += length(sum);

  std::vector<Outside> outsides;
  t = 0;
  for (const SourceMesh& mesh : model.meshes) {
    Outside& outside = outsides.emplace_back(Outside{.is_closed = true});
    double whole = 0, open = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3, ++t) {
      const std::uint32_t* at = &corners.position[3 * t];
      const std::uint32_t body = bodies.of(at[0]);
      outside.is_closed = outside.is_closed && !is_open[body] && volume[body] > 0;
      const double own = length(vector_product(minus(place[at[1]], place[at[0]]), minus(place[at[2]], place[at[0]])));
      whole += own;
      if (area[body] > 0) open += own * std::min(opening[body] / area[body], 1.0);
    }
    if (whole > 0) outside.opening = open / whole;
  }
  return outsides;
}

void weld(SourceMesh& mesh) {
  std::vector<unsigned> remap(mesh.vertices.size());
  const std::size_t kept =
      meshopt_generateVertexRemap(remap.data(), mesh.indices.data(), mesh.indices.size(), mesh.vertices.data(),
                                  mesh.vertices.size(), sizeof(SourceVertex));
  std::vector<SourceVertex> vertices(kept);
  meshopt_remapVertexBuffer(vertices.data(), mesh.vertices.data(), mesh.vertices.size(), sizeof(SourceVertex),
                            remap.data());
  meshopt_remapIndexBuffer(mesh.indices.data(), mesh.indices.data(), mesh.indices.size(), remap.data());
  mesh.vertices = std::move(vertices);
}

}  // namespace zstrip::sim
