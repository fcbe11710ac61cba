// Animations of a glTF file: curves of its nodes and of weights of morph targets.
#include "import/gltf/animations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "import/gltf/document.hpp"
#include "motion/fitted_animation.hpp"
#include "text/number.hpp"
#include "text/text.hpp"

namespace zstrip::sim {
namespace {

/// Duration of animations without motion, in seconds.
constexpr double kPoseDuration = 1;

/// A channel's node and path; empty if the node is not in the file.
struct Target {
  std::size_t node;
  std::string path;
};

std::optional<Target> target_of(const GltfJson& channel, std::size_t nodes) {
  const GltfJson& target = member(channel, "target");
  const std::optional<std::size_t> node = index_in(target, "node");
  if (!node || *node >= nodes) return std::nullopt;
  return Target{*node, text_in(target, "path")};
}

template <class Visit>
void for_each_channel(const GltfJson& json, const Visit& visit) {
  for (std::size_t i = 0; i < count_of(json, "animations"); ++i) {
    const GltfJson& animation = element(member(json, "animations"), i);
    for (std::size_t k = 0; k < count_of(animation, "channels"); ++k) {
      const GltfJson& channel = element(member(animation, "channels"), k);
      const auto target = target_of(channel, count_of(json, "nodes"));
      const std::optional<std::size_t> sampler = index_in(channel, "sampler");
      if (target) visit(*target, sampler ? element(member(animation, "samplers"), *sampler) : GltfJson());
    }
  }
}

Failure too_few_values() { return gltf_damaged("a sampler of an animation has too few values"); }

bool is_usable(const GltfMorphs::Weight& weight) { return std::isfinite(weight[0]); }
bool is_usable(const Vector& v) { return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]); }
bool is_usable(const Quaternion& q) {
  const double square = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
  return std::isfinite(square) && square > 1e-6;
}
bool is_finite(const GltfMorphs::Weight& weight) { return is_usable(weight); }
bool is_finite(const Vector& v) { return is_usable(v); }
bool is_finite(const Quaternion& q) {
  return std::isfinite(q[0]) && std::isfinite(q[1]) && std::isfinite(q[2]) && std::isfinite(q[3]);
}

template <typename Value>
Value value_at(const GltfValues<float>& values, std::size_t index) {
  Value value{};
  for (std::size_t i = 0; i < value.size(); ++i) value[i] = double{values.at(index)[i]};
  return value;
}

/// The numbers of a sampler, before their type is known.
struct Keys {
  Interpolation interpolation = Interpolation::linear;
  std::vector<float> times;
  GltfValues<float> values;

  bool spline() const { return interpolation == Interpolation::cubic_spline; }
  /// Returns the number of values of a key.
  std::size_t each() const { return spline() ? 3 : 1; }
};

Result<Keys> read_keys(const GltfJson& sampler, GltfAccessors& accessors) {
  const std::optional<std::size_t> input = index_in(sampler, "input"), output = index_in(sampler, "output");
  if (!input || !output) return gltf_damaged("a sampler of an animation lacks its accessors");
  Result<GltfValues<float>> times = accessors.floats(*input);
  if (!times) return times.failure();
  Result<GltfValues<float>> values = accessors.floats(*output);
  if (!values) return values.failure();
  const std::string word = text_in(sampler, "interpolation");
  if (!word.empty() && word != "LINEAR" && word != "STEP" && word != "CUBICSPLINE") {
    return gltf_damaged("a sampler of an animation has an interpolation that does not exist");
  }
  if (times->components != 1) return too_few_values();
  Keys keys{.times = std::move(times->numbers), .values = std::move(*values)};
  if (word == "STEP") keys.interpolation = Interpolation::step;
  if (word == "CUBICSPLINE") keys.interpolation = Interpolation::cubic_spline;
  return keys;
}

/// Keys that are not numbers, or not later than the key before, are left out and counted.
template <typename Value>
Result<Curve<Value>> curve_of(const Keys& keys, std::uint64_t& left_out) {
  Curve<Value> curve;
  curve.interpolation = keys.interpolation;
  const std::size_t each = keys.each();
  if (keys.values.components != Value{}.size() || keys.values.count() < each * keys.times.size()) {
    return too_few_values();
  }
  for (std::size_t i = 0; i < keys.times.size(); ++i) {
    const double time = double{keys.times[i]};
    const Value value = value_at<Value>(keys.values, each * i + each / 2);
    if (!std::isfinite(time) || !is_usable(value) || (!curve.times.empty() && time <= curve.times.back())) {
      ++left_out;
      continue;
    }
    curve.times.push_back(time);
    curve.values.push_back(value);
    if (!keys.spline()) continue;
    const auto slope = [&](std::size_t at) {
      const Value found = value_at<Value>(keys.values, at);
      return is_finite(found) ? found : Value{};
    };
    curve.slopes_in.push_back(slope(3 * i));
    curve.slopes_out.push_back(slope(3 * i + 2));
  }
  return curve;
}

template <typename Value>
Result<Done> set_curve(const GltfJson& sampler, GltfAccessors& accessors, Curve<Value>& curve,
                       std::uint64_t& left_out) {
  const Result<Keys> keys = read_keys(sampler, accessors);
  if (!keys) return keys.failure();
  Result<Curve<Value>> read = curve_of<Value>(*keys, left_out);
  if (!read) return read.failure();
  curve = std::move(*read);
  return Done{};
}

/// Returns a curve for each of `targets` morph targets: each key has a value for every one of them.
Result<std::vector<Curve<GltfMorphs::Weight>>> read_weights(const GltfJson& sampler, GltfAccessors& accessors,
                                                            std::size_t targets, std::uint64_t& left_out) {
  Result<Keys> keys = read_keys(sampler, accessors);
  if (!keys) return keys.failure();
  const GltfValues<float> all = std::move(keys->values);
  const std::size_t values = keys->each() * keys->times.size();
  if (all.components != 1 || all.count() / targets < values) return too_few_values();
  std::vector<Curve<GltfMorphs::Weight>> curves;
  for (std::size_t target = 0; target < targets; ++target) {
    keys->values = {.components = 1, .numbers = {}};
    for (std::size_t i = 0; i < values; ++i) keys->values.numbers.push_back(all.numbers[i * targets + target]);
    Result<Curve<GltfMorphs::Weight>> curve = curve_of<GltfMorphs::Weight>(*keys, left_out);
    if (!curve) return curve.failure();
    curves.push_back(std::move(*curve));
  }
  return curves;
}

/// Reads "extras": {"events": [seconds, number, seconds, number, ...]}, which Blender writes of an action's custom
/// property. Adds to `left_out` the events that no program can get.
std::vector<AnimationEvent> read_events(const GltfJson& animation, double duration, std::uint64_t& left_out) {
  std::vector<AnimationEvent> events;
  std::set<double> milliseconds;
  const GltfJson& all = member(member(animation, "extras"), "events");
  for (std::size_t i = 0; all.is_array() && i < all.size(); i += 2) {
    const double seconds = to_number(element(all, i), -1), number = to_number(element(all, i + 1), -1);
    const bool in_time = seconds >= 0 && std::round(seconds * 1000) < std::round(duration * 1000);
    if (in_time && number >= 0 && number <= 0xFFFF && milliseconds.insert(std::round(seconds * 1000)).second) {
      events.push_back({seconds, static_cast<std::uint16_t>(number)});
    } else {
      ++left_out;
    }
  }
  return events;
}

Result<NodeAnimation> read_animation(const GltfJson& from, GltfAccessors& accessors, const GltfNodes& nodes,
                                     GltfMorphs& morphs, std::uint64_t& left_out) {
  NodeAnimation animation;
  animation.name = text_in(from, "name");
  std::map<std::size_t, NodeCurves> moved;
  for (std::size_t k = 0; k < count_of(from, "channels"); ++k) {
    const GltfJson& channel = element(member(from, "channels"), k);
    const std::optional<std::size_t> node = index_in(member(channel, "target"), "node");
    if (node && *node >= nodes.size()) return gltf_damaged("an animation moves a node that does not exist");
    const std::optional<Target> target = target_of(channel, nodes.size());
    if (!target) continue;
    const GltfJson& sampler =
        element(member(from, "samplers"), index_in(channel, "sampler").value_or(static_cast<std::size_t>(-1)));
    const std::size_t targets = target->path == "weights" ? morphs.targets_of(target->node) : 0;
    if (targets > 0) {
      auto curves = read_weights(sampler, accessors, targets, left_out);
      if (!curves) return curves.failure();
      if (const Result<Done> added = morphs.add(target->node, std::move(*curves), animation); !added) {
        return added.failure();
      }
    }
    if (nodes.mover_of(target->node) == kNoNode) continue;
    Result<Done> done = Done{};
    if (target->path == "translation") done = set_curve(sampler, accessors, moved[target->node].translation, left_out);
    if (target->path == "rotation") done = set_curve(sampler, accessors, moved[target->node].rotation, left_out);
    if (target->path == "scale") done = set_curve(sampler, accessors, moved[target->node].scale, left_out);
    if (!done) return done.failure();
  }
  for (auto& [node, curves] : moved) {
    curves.node = nodes.mover_of(node);
    animation.moved.push_back(std::move(curves));
  }
  return animation;
}

}  // namespace

std::map<std::size_t, Vector> nodes_of_animations(const GltfJson& json, GltfAccessors& accessors) {
  std::map<std::size_t, Vector> nodes;
  for_each_channel(json, [&](const Target& target, const GltfJson& sampler) {
    const bool scales = target.path == "scale";
    if (!scales && target.path != "translation" && target.path != "rotation") return;
    Vector& largest = nodes[target.node];
    const std::optional<std::size_t> output = index_in(sampler, "output");
    if (!scales || !output) return;
    const Result<GltfValues<float>> values = accessors.floats(*output);
    if (!values || values->components != 3) return;  // read_gltf_animations() has words for it
    const bool spline = text_in(sampler, "interpolation") == "CUBICSPLINE";
    for (std::size_t i = spline ? 1 : 0; i < values->count(); i += spline ? 3 : 1) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double size = std::abs(double{values->at(i)[axis]});
        if (std::isfinite(size)) largest[axis] = std::max(largest[axis], size);
      }
    }
  });
  return nodes;
}

Result<Done> read_gltf_animations(const GltfJson& json, GltfAccessors& accessors, const GltfNodes& nodes,
                                  GltfMorphs& morphs, SourceModel& model) {
  std::vector<NodeAnimation> poses;  // animations of length 0; the first of the others is shown without a name
  for (std::size_t i = 0; i < count_of(json, "animations"); ++i) {
    std::uint64_t left_out = 0;
    const GltfJson& animation = element(member(json, "animations"), i);
    Result<NodeAnimation> read = read_animation(animation, accessors, nodes, morphs, left_out);
    if (!read) return read.failure();
    if (left_out > 0) {
      model.warnings.push_back(fmt::format("animation '{}': {} left out, no number or not later than the one before",
                                           printable(read->name), counted(left_out, "key")));
    }
    const std::set<double> times = key_times(*read);
    if (times.empty()) continue;
    nodes.set_rest_scale(*read);
    const bool is_pose = !(*times.rbegin() > 0);
    read->duration = is_pose ? kPoseDuration : *times.rbegin();
    if (read->duration > kMaxAnimation) {
      model.warnings.push_back(
          fmt::format("animation '{}' left out: it is longer than an hour", printable(read->name)));
      continue;
    }
    std::uint64_t events_left_out = 0;
    read->events = read_events(animation, read->duration, events_left_out);
    if (events_left_out > 0) {
      model.warnings.push_back(fmt::format(
          "animation '{}': {} left out: the time is not before its end, the number not 0 to 65535, or another event "
          "has the same millisecond",
          printable(read->name), counted(events_left_out, "event")));
    }
    (is_pose ? poses : model.nodes.animations).push_back(std::move(*read));
  }
  std::move(poses.begin(), poses.end(), std::back_inserter(model.nodes.animations));
  morphs.finish(model);
  return Done{};
}

}  // namespace zstrip::sim
