// The simplifier compares positions: vertices at one position are the two sides of a seam, and move along it together.
// Three or more at one position never move, which is how a vertex is made to stay: two copies that no triangle uses.
#include "import/moving_body.hpp"

#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>
#include <utility>

#include "import/surface.hpp"
#include "motion/affine.hpp"

namespace zstrip::sim {
namespace {

using Place = std::array<float, 3>;

/// The largest difference of a colour's channel across a triangle that may be removed.
constexpr int kSameColour = 24;
/// The largest sum of differences of joints' weights across a triangle that may be removed; 510 is all other joints.
constexpr int kSameJoints = 255;

Vector between(const Place& from, const Place& to) {
  return {double{to[0]} - from[0], double{to[1]} - from[1], double{to[2]} - from[2]};
}

/// Returns a vector of length 1, or of 0 for a triangle without area.
Vector face_normal(const Place& a, const Place& b, const Place& c) {
  Vector normal = vector_product(between(a, b), between(a, c));
  const double length = std::sqrt(scalar_product(normal, normal));
  for (double& component : normal) component = length > 0 ? component / length : 0;
  return normal;
}

/// Removes the normals of vertices that have those of all their faces: simplified, the faces stay flat.
void forget_flat_normals(SourceMesh& mesh) {
  constexpr double kSame = 0.9998;  // cosine of about a degree
  std::vector<bool> flat(mesh.vertices.size(), true);
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const auto at = [&](std::size_t corner) -> const SourceVertex& { return mesh.vertices[mesh.indices[i + corner]]; };
    const Vector face = face_normal(at(0).position, at(1).position, at(2).position);
    if (scalar_product(face, face) == 0) continue;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const auto& normal = at(corner).normal;
      if (scalar_product(face, {normal[0], normal[1], normal[2]}) < kSame) flat[mesh.indices[i + corner]] = false;
    }
  }
  for (std::size_t i = 0; i < flat.size(); ++i) {
    if (flat[i]) mesh.vertices[i].normal = {};
  }
  weld(mesh);
}

bool changes_colour(const SourceVertex& a, const SourceVertex& b) {
  for (std::size_t i = 0; i < 4; ++i) {
    if (std::abs(int{a.colour[i]} - int{b.colour[i]}) > kSameColour) return true;
  }
  return false;
}

bool changes_joints(const SourceVertex& a, const SourceVertex& b) {
  const auto weight_in = [](const SourceVertex& vertex, std::uint8_t joint) {
    int sum = 0;
    for (std::size_t i = 0; i < 4; ++i) sum += vertex.joints[i] == joint ? vertex.weights[i] : 0;
    return sum;
  };
  int difference = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    if (a.weights[i] > 0) difference += std::abs(weight_in(a, a.joints[i]) - weight_in(b, a.joints[i]));
    if (b.weights[i] > 0 && weight_in(a, b.joints[i]) == 0) difference += b.weights[i];
  }
  return difference > kSameJoints;
}

/// True if a morph target moves two neighbours apart, or towards each other, by more than half of their distance.
bool changes_offset(const SourceModel& model, const SourceVertex& a, const SourceVertex& b) {
  if (a.morph == b.morph) return false;
  const Vector edge = between(a.position, b.position);
  const double limit = scalar_product(edge, edge) / 4;
  std::map<std::uint32_t, Vector> apart;
  const auto add = [&](const SourceVertex& vertex, double sign) {
    if (vertex.morph == 0) return;
    for (const SourceMorphOffset& offset : model.morphs[vertex.morph - 1]) {
      for (std::size_t axis = 0; axis < 3; ++axis) apart[offset.weight][axis] += sign * double{offset.position[axis]};
    }
  };
  add(a, 1);
  add(b, -1);
  return std::ranges::any_of(apart, [&](const auto& each) { return scalar_product(each.second, each.second) > limit; });
}

/// The growth of texture coordinates from an edge towards the third corner of a triangle, at a right angle to the edge.
struct Growth {
  std::array<double, 2> slope{};  ///< for a unit of length
  double height = 0;              ///< of the triangle; 0: it has no area
};

Growth growth(const SourceVertex& a, const SourceVertex& b, const SourceVertex& c) {
  const Vector edge = between(a.position, b.position), side = between(a.position, c.position);
  const double square = scalar_product(edge, edge);
  if (square == 0) return {};
  const double along = scalar_product(edge, side) / square;
  const double height = std::sqrt(std::max(scalar_product(side, side) - along * along * square, 0.0));
  if (height == 0) return {};
  Growth grown{.height = height};
  for (std::size_t i = 0; i < 2; ++i) {
    grown.slope[i] = (double{c.texcoord[i]} - a.texcoord[i] - along * (double{b.texcoord[i]} - a.texcoord[i])) / height;
  }
  return grown;
}

/// Returns the colour of the texel at a place; the texture repeats.
const std::uint8_t* texel_at(const RgbImage& texture, const std::array<double, 2>& place) {
  const auto index = [](double coordinate, std::uint32_t side) {
    const double inside = coordinate - std::floor(coordinate);
    return std::min(static_cast<std::uint32_t>(inside * side), side - 1);
  };
  return texture.pixel(index(place[0], texture.width), index(place[1], texture.height));
}

/// True if texture coordinates do not go on across the edge from a to b as they come, a mirrored texture as a rule, and
/// the difference is seen. `texture`: null if it is not known.
bool is_fold(const SourceVertex& a, const SourceVertex& b, const SourceVertex& left, const SourceVertex& right,
             const RgbImage* texture) {
  constexpr double kUnseen = 1.0 / 512;  // of a texture's side, by which a corner may be off
  const Growth from = growth(a, b, left), to = growth(a, b, right);
  const double change = std::hypot(from.slope[0] + to.slope[0], from.slope[1] + to.slope[1]);
  if (change * std::min(from.height, to.height) <= kUnseen) return false;
  if (texture == nullptr) return true;
  const auto is_seen = [&](const Growth& known, const Growth& actual) {
    for (const double share : {0.5, 1.0}) {
      std::array<double, 2> expected{}, found{};
      for (std::size_t i = 0; i < 2; ++i) {
        const double middle = (double{a.texcoord[i]} + b.texcoord[i]) / 2;
        expected[i] = middle - known.slope[i] * actual.height * share;
        found[i] = middle + actual.slope[i] * actual.height * share;
      }
      const std::uint8_t *one = texel_at(*texture, expected), *other = texel_at(*texture, found);
      for (std::size_t channel = 0; channel < 3; ++channel) {
        if (std::abs(int{one[channel]} - int{other[channel]}) > kSameColour) return true;
      }
    }
    return false;
  };
  return is_seen(from, to) || is_seen(to, from);
}

}  // namespace

MovingBody::MovingBody(const SourceModel& model, std::vector<std::size_t> meshes, double unit)
    : meshes_(std::move(meshes)), unit_(unit) {
  for (const std::size_t number : meshes_) {
    SourceMesh mesh = model.meshes[number];
    forget_flat_normals(mesh);
    const auto first = static_cast<std::uint32_t>(vertices_.size());
    first_vertices_.push_back(first);
    vertices_.insert(vertices_.end(), mesh.vertices.begin(), mesh.vertices.end());
    for (const std::uint32_t index : mesh.indices) indices_.push_back(first + index);
    stays_.resize(vertices_.size());
    const std::uint32_t texture = model.materials.empty() ? kNoSourceTexture : model.materials[mesh.material].texture;
    const RgbImage* const image = texture == kNoSourceTexture ? nullptr : &model.textures[texture];
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> corners;  // opposite to each edge
    for (std::size_t k = 0; k < mesh.indices.size(); k += 3) {
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const std::uint32_t a = mesh.indices[k + corner], b = mesh.indices[k + (corner + 1) % 3];
        const std::uint32_t c = mesh.indices[k + (corner + 2) % 3];
        const SourceVertex &from = mesh.vertices[a], &to = mesh.vertices[b];
        bool stays = (mesh.has_colours && changes_colour(from, to)) || (mesh.has_skin && changes_joints(from, to)) ||
                     (mesh.has_morphs && changes_offset(model, from, to));
        if (mesh.has_texcoords) {
          corners[{a, b}] = c;
          const auto other = corners.find({b, a});
          stays = stays ||
                  (other != corners.end() && is_fold(from, to, mesh.vertices[c], mesh.vertices[other->second], image));
        }
        if (stays) stays_[first + a] = stays_[first + b] = true;
      }
    }
  }
  first_vertices_.push_back(vertices_.size());
  is_shared_.resize(vertices_.size());
  result_ = indices_;
  size_ = unit_ * double{meshopt_simplifyScale(vertices_[0].position.data(), vertices_.size(), sizeof(SourceVertex))};
}

std::vector<std::uint32_t> MovingBody::open_vertices() const {
  using Edge = std::pair<Place, Place>;
  std::map<Edge, int> uses;
  const auto for_each_edge = [&](const auto& visit) {
    for (std::size_t i = 0; i < indices_.size(); ++i) {
      visit(indices_[i], indices_[i % 3 == 2 ? i - 2 : i + 1]);
    }
  };
  for_each_edge([&](std::uint32_t a, std::uint32_t b) {
    ++uses[{vertices_[a].position, vertices_[b].position}];
    --uses[{vertices_[b].position, vertices_[a].position}];
  });
  std::set<std::uint32_t> open;
  for_each_edge([&](std::uint32_t a, std::uint32_t b) {
    if (uses[{vertices_[a].position, vertices_[b].position}] != 0) open.insert({a, b});
  });
  return {open.begin(), open.end()};
}

void MovingBody::keep_shared_borders(std::span<MovingBody> bodies) {
  if (bodies.size() < 2) return;
  struct Use {
    std::size_t body;
    std::uint32_t vertex;
  };
  std::map<Place, std::vector<Use>> uses;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    for (const std::uint32_t vertex : bodies[i].open_vertices()) {
      uses[bodies[i].vertices_[vertex].position].push_back({i, vertex});
    }
  }
  for (const auto& entry : uses) {
    const std::vector<Use>& users = entry.second;
    if (std::ranges::all_of(users, [&](const Use& use) { return use.body == users.front().body; })) continue;
    for (const Use& use : users) bodies[use.body].is_shared_[use.vertex] = true;
  }
}

void MovingBody::hold(Held held) {
  vertices_.resize(first_vertices_.back());
  std::set<Place> places;
  for (std::size_t i = 0; i < stays_.size(); ++i) {
    if (!is_shared_[i] && (held == Held::shared_borders || !stays_[i])) continue;
    if (!places.insert(vertices_[i].position).second) continue;
    SourceVertex copy{};
    copy.position = vertices_[i].position;
    vertices_.insert(vertices_.end(), 2, copy);
  }
}

void MovingBody::simplify(double error, std::size_t triangles) {
  if (!(size_ > 0)) return;
  std::vector<std::uint32_t> left(indices_.size());
  float reached = 0;
  left.resize(meshopt_simplify(left.data(), indices_.data(), indices_.size(), vertices_[0].position.data(),
                               vertices_.size(), sizeof(SourceVertex), 3 * triangles, static_cast<float>(error / size_),
                               0, &reached));
  if (left.empty()) return;
  result_ = std::move(left);
  error_ = double{reached} * size_;
}

void MovingBody::write_to(SourceModel& model) const {
  for (const std::size_t mesh : meshes_) {
    model.meshes[mesh].vertices.clear();
    model.meshes[mesh].indices.clear();
  }
  for (std::size_t i = 0; i < result_.size(); i += 3) {
    const auto owner = std::ranges::upper_bound(first_vertices_, std::size_t{result_[i]}) - 1;
    SourceMesh& mesh = model.meshes[meshes_[static_cast<std::size_t>(owner - first_vertices_.begin())]];
    const auto at = [&](std::size_t corner) -> const SourceVertex& { return vertices_[result_[i + corner]]; };
    const Vector face = face_normal(at(0).position, at(1).position, at(2).position);
    for (std::size_t corner = 0; corner < 3; ++corner) {
      SourceVertex vertex = at(corner);
      if (vertex.normal == std::array<float, 3>{}) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          vertex.normal[axis] = static_cast<float>(face[axis]) + 0.0F;  // no negative zero
        }
        if (scalar_product(face, face) == 0) vertex.normal = {0, 0, 1};
      }
      mesh.indices.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
      mesh.vertices.push_back(vertex);
    }
  }
  for (const std::size_t mesh : meshes_) weld(model.meshes[mesh]);
}

}  // namespace zstrip::sim
