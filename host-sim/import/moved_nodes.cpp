// Which of Assimp's nodes a file's animations move, and how.
#include "import/moved_nodes.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>
#include <span>
#include <string>
#include <utility>

#include "import/gltf_interpolation.hpp"
#include "motion/fitted_animation.hpp"
#include "report/number.hpp"

namespace zstrip::sim {
namespace {

/// More would take minutes to look at, each at thousands of times.
constexpr std::size_t kMaxMoved = 4096;
constexpr std::uint32_t kDeepest = 64;

std::span<const aiAnimation* const> animations_of(const aiScene& scene) {
  return {scene.mAnimations, scene.mNumAnimations};
}
std::span<const aiNodeAnim* const> channels_of(const aiAnimation& animation) {
  return {animation.mChannels, animation.mNumChannels};
}

Vector value_of(const aiVectorKey& key) { return {key.mValue.x, key.mValue.y, key.mValue.z}; }
Quaternion value_of(const aiQuatKey& key) { return {key.mValue.x, key.mValue.y, key.mValue.z, key.mValue.w}; }

bool usable(const Vector& v) { return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]); }
bool usable(const Quaternion& q) {
  const double square = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
  return std::isfinite(square) && square > 1e-6;
}

/// Keys that are no numbers, or not later than the one before, are left out.
template <typename Value, typename Key>
Curve<Value> to_curve(std::span<Key> keys, double ticks_per_second) {
  Curve<Value> curve;
  for (const Key& key : keys) {
    const double time = key.mTime / ticks_per_second;
    const Value value = value_of(key);
    if (!std::isfinite(time) || !usable(value) || (!curve.times.empty() && time <= curve.times.back())) continue;
    curve.times.push_back(time);
    curve.values.push_back(value);
  }
  return curve;
}

/// Makes steps of curves that are; returns how many are splines, whose slopes Assimp drops.
std::size_t interpolate(const std::vector<NodeInterpolation>& known, const std::string& node, NodeCurves& curves) {
  std::size_t splines = 0;
  const auto set = [&splines](Interpolation from, Interpolation& to) {
    if (from == Interpolation::cubic_spline) ++splines;
    if (from == Interpolation::step) to = Interpolation::step;
  };
  for (const NodeInterpolation& each : known) {
    if (each.node != node) continue;
    set(each.translation, curves.translation.interpolation);
    set(each.rotation, curves.rotation.interpolation);
    set(each.scale, curves.scale.interpolation);
  }
  return splines;
}

}  // namespace

Affine to_affine(const aiMatrix4x4& from) {
  Affine to;
  to.m = {{{from.a1, from.a2, from.a3, from.a4},
           {from.b1, from.b2, from.b3, from.b4},
           {from.c1, from.c2, from.c3, from.c4}}};
  return to;
}

MovedNodes::MovedNodes(const aiScene& scene, const aiMatrix4x4& turn, const std::filesystem::path& file,
                       SourceModel& model) {
  if (file.empty() || scene.mNumAnimations == 0 || scene.mRootNode == nullptr) return;
  find_moved(scene, turn, model);
  if (!model.nodes.nodes.empty()) read_animations(scene, file, model);
}

std::int32_t MovedNodes::mover_of(const aiNode& node) const {
  const auto at = movers_.find(&node);
  return at == movers_.end() ? kNoNode : at->second;
}

void MovedNodes::find_moved(const aiScene& scene, const aiMatrix4x4& turn, SourceModel& model) {
  std::set<std::string> names;
  for (const aiAnimation* animation : animations_of(scene)) {
    for (const aiNodeAnim* channel : channels_of(*animation)) names.insert(channel->mNodeName.C_Str());
  }
  /// What is known of a node before it is looked at.
  struct Open {
    const aiNode* node;
    std::int32_t mover;
    Affine before;
    std::uint32_t depth;
  };
  const auto give_up = [&](const char* why) {
    model.warnings.push_back(fmt::format("animations left out: {}", why));
    model.nodes = {};
    movers_.clear();
  };
  std::vector<Open> open{{scene.mRootNode, kNoNode, to_affine(turn), 0}};
  while (!open.empty()) {
    Open at = open.back();
    open.pop_back();
    const Affine at_rest = to_affine(at.node->mTransformation);
    if (names.contains(at.node->mName.C_Str())) {
      // Vertices are kept where they are at rest: that must have a way back.
      if (!(std::abs(determinant(at.before * at_rest)) > 1e-12)) return give_up("a node has no size at rest");
      if (model.nodes.nodes.size() >= kMaxMoved || ++at.depth > kDeepest) return give_up("too many nodes move");
      const auto index = static_cast<std::int32_t>(model.nodes.nodes.size());
      model.nodes.nodes.push_back({.parent = at.mover, .before = at.before, .at_rest = at_rest});
      at.mover = index;
      at.before = {};
    } else {
      at.before = at.before * at_rest;
    }
    if (at.mover != kNoNode) movers_.emplace(at.node, at.mover);
    for (unsigned child = at.node->mNumChildren; child-- > 0;) {
      open.push_back({at.node->mChildren[child], at.mover, at.before, at.depth});
    }
  }
}

void MovedNodes::read_animations(const aiScene& scene, const std::filesystem::path& file, SourceModel& model) const {
  const std::vector<std::vector<NodeInterpolation>> interpolations = read_interpolations(file);
  std::size_t splines = 0;
  for (std::size_t i = 0; i < scene.mNumAnimations; ++i) {
    const aiAnimation& from = *scene.mAnimations[i];
    NodeAnimation to;
    to.name = from.mName.C_Str();
    const double ticks_per_second = from.mTicksPerSecond > 0 ? from.mTicksPerSecond : 25;
    for (const aiNodeAnim* channel : channels_of(from)) {
      const aiNode* node = scene.mRootNode->FindNode(channel->mNodeName);
      if (node == nullptr) continue;
      NodeCurves& curves = to.moved.emplace_back();
      curves.node = mover_of(*node);
      curves.translation =
          to_curve<Vector>(std::span(channel->mPositionKeys, channel->mNumPositionKeys), ticks_per_second);
      curves.rotation =
          to_curve<Quaternion>(std::span(channel->mRotationKeys, channel->mNumRotationKeys), ticks_per_second);
      curves.scale = to_curve<Vector>(std::span(channel->mScalingKeys, channel->mNumScalingKeys), ticks_per_second);
      if (i < interpolations.size()) splines += interpolate(interpolations[i], channel->mNodeName.C_Str(), curves);
    }
    const std::set<double> times = key_times(to);
    if (times.empty() || !(*times.rbegin() > 0)) continue;
    to.duration = *times.rbegin();
    if (to.duration > kMaxAnimation) {
      model.warnings.push_back(fmt::format("animation '{}' left out: it is longer than an hour", to.name));
      continue;
    }
    model.nodes.animations.push_back(std::move(to));
  }
  if (splines > 0) {
    model.warnings.push_back(
        fmt::format("{} drawn as straight lines between their keys", counted(splines, "cubic spline")));
  }
}

}  // namespace zstrip::sim
