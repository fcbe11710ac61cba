// Converts a model file's animation to the renderer's.
#include "render/model_animation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "import/quantise.hpp"
#include "import/quantised_skins.hpp"

namespace zstrip::sim {
namespace {

constexpr std::uint32_t kPoses = 24;

}  // namespace

Result<const NodeAnimation*> find_animation(const Model& model, const std::optional<std::string>& name) {
  const std::vector<NodeAnimation>& all = model.tree.animations;
  if (!name) return all.empty() ? nullptr : all.data();
  const auto at = std::ranges::find(all, *name, &NodeAnimation::name);
  if (at != all.end()) return &*at;
  std::string names;
  for (const NodeAnimation& animation : all) names += fmt::format("{}'{}'", names.empty() ? "" : ", ", animation.name);
  return Failure{ExitStatus::input,
                 fmt::format("there is no animation '{}' in the file; {}", *name,
                             names.empty() ? "it has none that moves nodes, or is not glTF 2.0" : "it has " + names)};
}

Affine moved_from_rest(const Model& model, const NodeAnimation& animation, std::int32_t node, double seconds) {
  return model.tree.at(animation, node, seconds) * inverse(model.tree.at_rest(node));
}

std::vector<Vector> corners_of_box(const Vector& low, const Vector& high) {
  std::vector<Vector> corners;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const auto side = [&](std::size_t axis) { return (corner >> axis & 1) != 0 ? high[axis] : low[axis]; };
    corners.push_back({side(0), side(1), side(2)});
  }
  return corners;
}

std::vector<Vector> corners_of(const Mesh& mesh) {
  Vector low{}, high{};
  const std::array<Fixed, 3> centre{mesh.centre.x, mesh.centre.y, mesh.centre.z};
  const std::array<Fixed, 3> half{mesh.half_extent.x, mesh.half_extent.y, mesh.half_extent.z};
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Position& p = mesh.positions[i];
    const std::array<std::int16_t, 3> steps{p.x, p.y, p.z};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double at = from_fixed(centre[axis]) + from_fixed(half[axis]) * steps[axis] / 32768;
      low[axis] = i == 0 ? at : std::min(low[axis], at);
      high[axis] = i == 0 ? at : std::max(high[axis], at);
    }
  }
  return corners_of_box(low, high);
}

Result<FittedAnimation> fit_model_animation(const Model& model, const NodeAnimation& animation) {
  const double scale = model.units.scale;
  const auto& origin = model.units.origin;
  const Affine to_scene = scaling({scale, scale, scale}) * translation({-origin[0], -origin[1], -origin[2]});
  const Affine to_file = inverse(to_scene);
  std::vector<InstanceMotion> motions;
  for (std::size_t i = 0; i < model.instances.size(); ++i) {
    const std::int32_t node = model.nodes[i];
    if (node == kNoNode || !model.tree.moves(animation, node)) continue;
    motions.push_back(
        {.instance = static_cast<std::uint16_t>(i),
         .at = [&model, &animation, to_scene, to_file,
                node](double seconds) { return to_scene * moved_from_rest(model, animation, node, seconds) * to_file; },
         .corners = corners_of(model.meshes[model.instances[i].mesh])});
  }
  return fit_animation(motions, animation.duration, key_times(animation), kAnimationTolerance);
}

Result<FittedAnimation> fit_joint_animation(const Model& model, const NodeAnimation& animation, double tolerance) {
  std::size_t longest = 1;  // length of the longest chain of joints, along which errors add up
  std::vector<InstanceMotion> motions;
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    const ModelJoint& joint = model.joint_nodes[i];
    if (std::ranges::find(animation.moved, joint.node, &NodeCurves::node) == animation.moved.end()) continue;
    std::size_t chain = 1;
    for (std::size_t at = joint.parent; at != kNoSourceJoint; at = model.joint_nodes[at].parent) ++chain;
    longest = std::max(longest, chain);
    const double reach = joint.reach;
    motions.push_back(
        {.instance = static_cast<std::uint16_t>(i),
         .at = [&model, &animation, i](double seconds) { return local_of(model, i, &animation, seconds); },
         .corners = corners_of_box({-reach, -reach, -reach}, {reach, reach, reach})});
  }
  return fit_animation(motions, animation.duration, key_times(animation), tolerance / static_cast<double>(longest));
}

Result<FittedWeights> fit_weight_animation(const Model& model, const NodeAnimation& animation, double tolerance) {
  // Normals move, too: an error of a weight must not be seen in the light, either.
  constexpr double kMaxError = 1.0 / 256, kMinError = 1.0 / 2048;
  std::vector<double> tolerances;
  for (const ModelWeight& weight : model.weights) {
    const auto index = static_cast<std::size_t>(&weight - model.weights.data());
    const auto has_target = [index](const ModelMorph& morph) {
      return std::ranges::find(morph.targets, index, &MorphTarget::weight) != morph.targets.end();
    };
    if (std::ranges::none_of(model.morphs, has_target)) {
      tolerances.push_back(0);  // a blob has no weights that move nothing
      continue;
    }
    const double together = weight.reach * static_cast<double>(animation.weights.size());
    tolerances.push_back(together > 0 ? std::clamp(tolerance / together, kMinError, kMaxError) : kMaxError);
  }
  return fit_weights(animation, tolerances);
}

std::vector<ClipEvent> fit_events(std::span<const AnimationEvent> events, std::uint32_t duration) {
  std::map<std::uint32_t, std::uint16_t> numbers;  // by milliseconds
  for (const AnimationEvent& event : events) {
    const double milliseconds = std::round(event.seconds * 1000);
    if (milliseconds < duration) numbers.emplace(static_cast<std::uint32_t>(milliseconds), event.number);
  }
  std::vector<ClipEvent> fitted;
  for (const auto& [time, number] : numbers) fitted.push_back({.clip = 0, .number = number, .time = time});
  return fitted;
}

std::vector<Instance> all_poses(const Animation& animation, std::span<const Instance> instances) {
  std::vector<Instance> all;
  const std::uint32_t poses = animation.tracks.empty() ? 1 : kPoses;
  for (std::uint32_t i = 0; i < poses; ++i) {
    const std::size_t first = all.size();
    all.insert(all.end(), instances.begin(), instances.end());
    if (!animation.tracks.empty()) pose(animation, time_of_frame(animation, i, poses), std::span(all).subspan(first));
  }
  return all;
}

}  // namespace zstrip::sim
