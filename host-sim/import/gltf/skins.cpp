// Converts skins of a glTF file to joints: the joints that move a vertex, and the vertex's position.
#include "import/gltf/skins.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

#include "import/gltf/document.hpp"
#include "text/number.hpp"
#include "zstrip/skin.hpp"

namespace zstrip::sim {
namespace {

bool nearly_equal(const Affine& a, const Affine& b) {
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 4; ++column) {
      const double scale = std::max({1.0, std::abs(a.m[row][column]), std::abs(b.m[row][column])});
      if (std::abs(a.m[row][column] - b.m[row][column]) > 1e-5 * scale) return false;
    }
  }
  return true;
}

bool has_inverse(const Affine& affine) {
  double sum = 0;
  for (const auto& row : affine.m) sum += std::abs(row[0]) + std::abs(row[1]) + std::abs(row[2]) + std::abs(row[3]);
  return std::isfinite(sum) && std::abs(determinant(affine)) > 1e-12;
}

void add_scaled(Affine& sum, const Affine& part, double weight) {
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 4; ++column) sum.m[row][column] += weight * part.m[row][column];
  }
}

}  // namespace

Result<GltfSkins::Binds> GltfSkins::read_binds(const GltfJson& skin, std::size_t node) {
  Binds binds;
  const GltfJson& joints = member(skin, "joints");
  for (std::size_t i = 0; i < count_of(skin, "joints"); ++i) {
    const std::optional<std::size_t> joint = to_index(element(joints, i));
    if (!joint || *joint >= nodes_.size()) return gltf_damaged("a skin has a joint that does not exist");
    binds.nodes.push_back(*joint);
  }
  binds.inverse_binds.resize(binds.nodes.size());
  if (const std::optional<std::size_t> accessor = index_in(skin, "inverseBindMatrices")) {
    const Result<GltfValues<float>> matrices = accessors_.floats(*accessor);
    if (!matrices) return matrices.failure();
    if (matrices->components != 16 || matrices->count() < binds.nodes.size()) {
      return gltf_damaged("a skin has too few matrices");
    }
    for (std::size_t i = 0; i < binds.nodes.size(); ++i) {
      std::array<double, 16> columns{};
      std::copy_n(matrices->at(i), columns.size(), columns.begin());
      binds.inverse_binds[i] = affine_of_columns(columns);
    }
  }
  binds.nodes.push_back(node);
  binds.inverse_binds.emplace_back();
  return binds;
}

Result<std::vector<std::vector<GltfSkins::Influence>>> GltfSkins::read_influences(const GltfAttributes& primitive,
                                                                                  std::size_t vertices,
                                                                                  std::size_t binds) {
  std::vector<std::vector<Influence>> influences(vertices);
  std::vector<bool> unweighted(vertices);
  for (std::size_t set = 0;; ++set) {
    const std::string of_joints = fmt::format("JOINTS_{}", set), of_weights = fmt::format("WEIGHTS_{}", set);
    if (!primitive.has(of_joints) || !primitive.has(of_weights)) break;
    const Result<GltfValues<std::uint32_t>> joints = primitive.integers(of_joints, vertices, 4);
    if (!joints) return joints.failure();
    const Result<GltfValues<float>> weights = primitive.floats(of_weights, vertices, 4);
    if (!weights) return weights.failure();
    for (std::size_t i = 0; i < vertices; ++i) {
      for (std::size_t k = 0; k < 4; ++k) {
        const double weight = double{weights->at(i)[k]};
        if (!(weight >= 0) || !std::isfinite(weight)) unweighted[i] = true;
        if (!(weight > 0) || !std::isfinite(weight)) continue;
        const std::size_t joint = joints->at(i)[k];
        if (joint + 1 >= binds) return gltf_damaged("a mesh has a joint that its skin lacks");
        influences[i].push_back({joint, weight});
      }
    }
  }
  for (std::size_t i = 0; i < vertices; ++i) {
    if (unweighted[i]) {
      ++unweighted_;
    } else if (influences[i].empty()) {
      ++weightless_;
    }
  }
  return influences;
}

std::size_t GltfSkins::joint_of_node(std::int32_t node) {
  if (node == kNoNode) return kNoSourceJoint;
  std::vector<SourceJoint>& joints = model_.joints;
  const auto known = std::ranges::find(joints, node, &SourceJoint::node);
  if (known != joints.end()) return static_cast<std::size_t>(known - joints.begin());
  const std::size_t parent = joint_of_node(model_.nodes.nodes[static_cast<std::size_t>(node)].parent);
  joints.push_back({.parent = parent, .node = node, .inverse_bind = {}});
  return joints.size() - 1;
}

std::size_t GltfSkins::joint_with(std::size_t node, const Affine& inverse_bind, const Affine& modelled) {
  std::vector<SourceJoint>& joints = model_.joints;
  const std::int32_t mover = nodes_.mover_of(node);
  Affine bind = nodes_.world(node) * inverse_bind * inverse(modelled);
  if (mover != kNoNode) bind = inverse(model_.nodes.at_rest(mover)) * bind;
  const std::size_t of_mover = joint_of_node(mover);
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const bool hangs_there = i == of_mover || (joints[i].node == kNoNode && joints[i].parent == of_mover);
    if (hangs_there && joints[i].has_vertices && nearly_equal(joints[i].inverse_bind, bind)) return i;
  }
  std::size_t index = of_mover;
  if (of_mover == kNoSourceJoint || joints[of_mover].has_vertices) {
    index = joints.size();
    joints.push_back({.parent = of_mover, .node = kNoNode, .inverse_bind = {}});
  }
  joints[index].inverse_bind = bind;
  joints[index].has_vertices = true;
  return index;
}

SkinnedVertex GltfSkins::strongest(const std::vector<Influence>& influences, const std::vector<std::size_t>& joints) {
  std::map<std::size_t, double> by_joint;
  for (const Influence& influence : influences) by_joint[joints[influence.bind]] += influence.weight;
  std::vector<std::pair<double, std::size_t>> sorted;
  for (const auto& [joint, weight] : by_joint) sorted.emplace_back(weight, joint);
  std::ranges::stable_sort(sorted, std::greater<>(), &std::pair<double, std::size_t>::first);
  if (sorted.size() > 4) {
    ++weakened_;
    sorted.resize(4);
  }
  double sum = 0;
  for (const auto& [weight, joint] : sorted) sum += weight;
  // The sum is 256; the rest of the rounding goes to the first weight, which counts one more than its value.
  SkinnedVertex vertex;
  int left = 256;
  for (std::size_t k = 1; k < sorted.size(); ++k) {
    const auto weight = static_cast<int>(std::lround(256 * sorted[k].first / sum));
    vertex.weights[k] = static_cast<std::uint8_t>(weight);
    if (weight > 0) vertex.joints[k] = static_cast<std::uint8_t>(sorted[k].second);
    left -= weight;
  }
  vertex.joints[0] = static_cast<std::uint8_t>(sorted[0].second);
  vertex.weights[0] = static_cast<std::uint8_t>(left - 1);
  return vertex;
}

Result<SkinnedPrimitive> GltfSkins::read(const GltfAttributes& primitive, std::size_t vertices, std::size_t node) {
  SkinnedPrimitive read{.modelled = nodes_.world(node)};
  const std::optional<std::size_t> skin = index_in(element(member(json_, "nodes"), node), "skin");
  if (!skin || !primitive.has("JOINTS_0")) return read;
  if (*skin >= count_of(json_, "skins")) return gltf_damaged(fmt::format("there is no skin {}", *skin));
  const Result<Binds> binds = read_binds(element(member(json_, "skins"), *skin), node);
  if (!binds) return binds.failure();
  const std::size_t own = binds->nodes.size() - 1;
  auto influences = read_influences(primitive, vertices, binds->nodes.size());
  if (!influences) return influences.failure();
  const auto to_file = [&](std::size_t bind) { return nodes_.world(binds->nodes[bind]) * binds->inverse_binds[bind]; };
  // Joints whose matrix makes a vertex vanish or has no inverse move nothing.
  std::vector<bool> usable(own);
  for (std::size_t i = 0; i < own; ++i) usable[i] = has_inverse(to_file(i));
  for (std::vector<Influence>& each : *influences) {
    if (std::erase_if(each, [&](const Influence& influence) { return !usable[influence.bind]; }) > 0) ++unmoved_;
    if (each.empty()) each.push_back({own, 1});
  }
  const bool moves = std::any_of(binds->nodes.begin(), binds->nodes.end() - 1,
                                 [&](std::size_t joint) { return nodes_.mover_of(joint) != kNoNode; });
  if (moves && vertices > 0) {
    const Affine first = to_file((*influences)[0][0].bind);
    if (has_inverse(first)) read.modelled = first;
    const std::vector<SourceJoint> before = model_.joints;
    std::vector<std::size_t> joints(binds->nodes.size(), kNoSourceJoint);
    // A skin with too many joints is drawn at rest: its other joints are not compared with all before them.
    for (const std::vector<Influence>& each : *influences) {
      for (const auto& [bind, weight] : each) {
        if (joints[bind] != kNoSourceJoint || model_.joints.size() > kMaxJoints) continue;
        joints[bind] = joint_with(binds->nodes[bind], binds->inverse_binds[bind], read.modelled);
      }
    }
    if (model_.joints.size() <= kMaxJoints) {
      for (const std::vector<Influence>& each : *influences) read.joints.push_back(strongest(each, joints));
      return read;
    }
    model_.joints = before;
    ++still_;
  }
  for (const std::vector<Influence>& each : *influences) {
    const double sum = std::accumulate(each.begin(), each.end(), 0.0,
                                       [](double all, const Influence& influence) { return all + influence.weight; });
    Affine blended{};
    blended.m = {};
    for (const auto& [bind, weight] : each) add_scaled(blended, to_file(bind), weight / sum);
    read.at_rest.push_back(blended);
  }
  return read;
}

void GltfSkins::warn() const {
  if (unweighted_ > 0) {
    model_.warnings.push_back(
        fmt::format("{} of skins: weights left out that are negative or not finite", counted(unweighted_, "corner")));
  }
  if (weightless_ > 0) {
    model_.warnings.push_back(fmt::format("{} of skins: all weights are zero, so that no joint moves {}",
                                          counted(weightless_, "corner"), weightless_ == 1 ? "it" : "them"));
  }
  if (unmoved_ > 0) {
    model_.warnings.push_back(
        fmt::format("{} of skins: joints left out whose matrix has no inverse", counted(unmoved_, "corner")));
  }
  if (weakened_ > 0) {
    model_.warnings.push_back(
        fmt::format("{} moved by the strongest four of their joints", counted(weakened_, "corner")));
  }
  if (still_ > 0) {
    model_.warnings.push_back(
        fmt::format("{} with a skin drawn at rest: more than {} joints", counted(still_, "mesh"), kMaxJoints));
  }
}

}  // namespace zstrip::sim
