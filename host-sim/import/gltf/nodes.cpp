// The nodes of a glTF file.
#include "import/gltf/nodes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "import/gltf/document.hpp"

namespace zstrip::sim {
namespace {

/// With more moving nodes, sampling thousands of times would take minutes.
constexpr std::size_t kMaxMoved = 4096;
constexpr std::uint32_t kDeepestMoved = 64;

bool has_size(const Affine& map) { return std::abs(determinant(map)) > 1e-30; }

/// Returns nothing if the node has a matrix.
std::optional<Placement> parts_of_node(const GltfJson& node) {
  if (member(node, "matrix").is_array()) return {};
  Placement placement{.translation = numbers_in<3>(node, "translation", {0, 0, 0}),
                      .rotation = numbers_in<4>(node, "rotation", {0, 0, 0, 1}),
                      .scale = numbers_in<3>(node, "scale", {1, 1, 1})};
  const Quaternion& q = placement.rotation;
  const double square = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
  if (!(std::isfinite(square) && square > 1e-12)) placement.rotation = {0, 0, 0, 1};
  return placement;
}

}  // namespace

Affine affine_of_columns(const std::array<double, 16>& columns) {
  Affine affine;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 4; ++column) affine.m[row][column] = columns[4 * column + row];
  }
  return affine;
}

Result<GltfNodes> GltfNodes::read(const GltfJson& json, const Affine& turn) {
  GltfNodes read;
  const GltfJson& nodes = member(json, "nodes");
  read.nodes_.resize(count_of(json, "nodes"));
  for (std::size_t i = 0; i < read.nodes_.size(); ++i) {
    const GltfJson& node = element(nodes, i);
    read.nodes_[i].parts = parts_of_node(node);
    read.nodes_[i].local =
        read.nodes_[i].parts
            ? to_affine(*read.nodes_[i].parts)
            : affine_of_columns(numbers_in<16>(node, "matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}));
    read.nodes_[i].name = text_in(node, "name");
    if (read.nodes_[i].name.empty()) read.nodes_[i].name = fmt::format("node {}", i);
    const GltfJson& visible = member(extension(node, "KHR_node_visibility"), "visible");
    read.nodes_[i].visible = !visible.is_boolean() || visible.get<bool>();
    const GltfJson& children = member(node, "children");
    for (std::size_t k = 0; k < count_of(node, "children"); ++k) {
      const std::optional<std::size_t> child = to_index(element(children, k));
      if (!child || *child >= read.nodes_.size()) {
        return gltf_damaged(fmt::format("node {} has a child that does not exist", i));
      }
      std::optional<std::size_t>& parent = read.nodes_[*child].parent;
      if (parent == i) return gltf_damaged(fmt::format("node {} has the child {} twice", i, *child));
      if (parent) return gltf_damaged(fmt::format("node {} has two parents", *child));
      parent = i;
      read.nodes_[i].children.push_back(*child);
    }
  }
  if (const std::optional<std::size_t> node = read.node_in_a_circle()) {
    return gltf_damaged(
        fmt::format("node {} is its own {}", *node, read.nodes_[*node].parent == node ? "child" : "ancestor"));
  }
  // Without scenes all roots are shown; without a default scene that exists the first one.
  if (count_of(json, "scenes") > 0) {
    const std::size_t chosen = index_in(json, "scene").value_or(0);
    const GltfJson& scene = element(member(json, "scenes"), chosen < count_of(json, "scenes") ? chosen : 0);
    const GltfJson& roots = member(scene, "nodes");
    std::vector<bool> listed(read.nodes_.size());
    for (std::size_t k = 0; k < count_of(scene, "nodes"); ++k) {
      const std::optional<std::size_t> root = to_index(element(roots, k));
      if (!root || *root >= read.nodes_.size()) return gltf_damaged("its scene has a node that does not exist");
      if (listed[*root]) continue;
      listed[*root] = true;
      read.roots_.push_back(*root);
      read.nodes_[*root].parent.reset();
    }
    // A node that the scene lists is a root there, even if an exporter left it below a node outside of the scene.
    for (std::size_t i = 0; i < read.nodes_.size(); ++i) {
      std::erase_if(read.nodes_[i].children, [&](std::size_t child) { return read.nodes_[child].parent != i; });
    }
  } else {
    for (std::size_t i = 0; i < read.nodes_.size(); ++i) {
      if (!read.nodes_[i].parent) read.roots_.push_back(i);
    }
  }
  read.place_all(turn);
  return read;
}

void GltfNodes::place_all(const Affine& turn) {
  in_scene_.clear();
  // Joints may be outside of the scene: they have positions, too.
  std::vector<bool> seen(nodes_.size());
  const auto walk = [&](std::size_t root, bool in_scene) {
    std::vector<std::size_t> open{root};
    while (!open.empty()) {
      const std::size_t at = open.back();
      open.pop_back();
      if (seen[at]) continue;
      seen[at] = true;
      Place& place = nodes_[at];
      const Place* const parent = place.parent ? &nodes_[*place.parent] : nullptr;
      place.world = (parent != nullptr ? parent->world : turn) * place.local;
      place.visible = place.visible && (parent == nullptr || parent->visible);
      if (in_scene) in_scene_.push_back(at);
      // In reverse, so that children are removed from the stack in the file's order.
      open.insert(open.end(), place.children.rbegin(), place.children.rend());
    }
  };
  for (const std::size_t root : roots_) walk(root, true);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (!nodes_[i].parent) walk(i, false);
  }
}

std::optional<std::size_t> GltfNodes::node_in_a_circle() const {
  // The walk towards the root that came to each node; walks end where another one has been.
  std::vector<std::optional<std::size_t>> walks(nodes_.size());
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    std::optional<std::size_t> at = i;
    for (; at && !walks[*at]; at = nodes_[*at].parent) walks[*at] = i;
    if (at && walks[*at] == i) return at;
  }
  return std::nullopt;
}

void GltfNodes::set_moved(const std::map<std::size_t, Vector>& moved, const Affine& turn, SourceModel& model) {
  bool larger = false;
  for (const auto& [node, largest] : moved) larger = enlarge(nodes_[node], largest) || larger;
  if (larger) place_all(turn);
  /// The data of a node before it is visited.
  struct Open {
    std::size_t node;
    std::int32_t mover;
    Affine before;
    std::uint32_t depth;
  };
  const auto give_up = [&](const char* why) {
    model.warnings.push_back(fmt::format("animations left out: {}", why));
    model.nodes = {};
    for (Place& place : nodes_) place.mover = kNoNode;
  };
  std::vector<Open> open;
  for (std::size_t i = roots_.size(); i-- > 0;) open.push_back({roots_[i], kNoNode, turn, 0});
  while (!open.empty()) {
    Open at = open.back();
    open.pop_back();
    Place& place = nodes_[at.node];
    // Vertices are stored in the pose at rest, whose map must have an inverse. Below a node of no size that does not
    // grow nothing is seen.
    if (moved.contains(at.node) && has_size(at.before * place.local)) {
      if (model.nodes.nodes.size() >= kMaxMoved || ++at.depth > kDeepestMoved) return give_up("too many nodes move");
      const auto index = static_cast<std::int32_t>(model.nodes.nodes.size());
      model.nodes.nodes.push_back(
          {.parent = at.mover, .before = at.before, .at_rest = place.local, .parts = place.parts, .name = place.name});
      at.mover = index;
      at.before = {};
    } else {
      at.before = at.before * place.local;
    }
    place.mover = at.mover;
    for (std::size_t i = place.children.size(); i-- > 0;) {
      open.push_back({place.children[i], at.mover, at.before, at.depth});
    }
  }
}

bool GltfNodes::enlarge(Place& place, const Vector& largest) {
  constexpr double kMuch = 64;  // a mesh keeps 10 of its 16 bits
  Placement placement = place.parts ? *place.parts : to_placement(place.local);
  const Vector at_rest = placement.scale;
  bool larger = false;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double most = largest[axis] > 0 ? largest[axis] : 1;
    if (at_rest[axis] != 0 && std::abs(at_rest[axis]) * kMuch >= largest[axis]) continue;
    placement.scale[axis] = std::copysign(most, at_rest[axis]);
    larger = true;
  }
  if (!larger) return false;
  place.rest_scale = at_rest;
  place.local = to_affine(placement);
  place.parts = placement;
  return true;
}

void GltfNodes::set_rest_scale(NodeAnimation& animation) const {
  for (const Place& place : nodes_) {
    if (!place.rest_scale || place.mover == kNoNode) continue;
    auto at = std::ranges::find(animation.moved, place.mover, &NodeCurves::node);
    if (at == animation.moved.end()) {
      at = animation.moved.emplace(at);
      at->node = place.mover;
    }
    if (!at->scale.times.empty()) continue;
    at->scale.times = {0};
    at->scale.values = {*place.rest_scale};
  }
}

}  // namespace zstrip::sim
