// Joins animations of a model to one: each is shown for some seconds, and fades into the next.
#include "motion/clip_sequence.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

namespace zstrip::sim {
namespace {

constexpr double kValuesPerSecond = 60;
constexpr double kJump = 1e-4;  // seconds that a step without a fade takes to begin

double time_in(const NodeAnimation& clip, double seconds) {
  return seconds > clip.duration ? std::fmod(seconds, clip.duration) : seconds;
}

double weight_of(const NodeAnimation& clip, std::uint32_t weight, double seconds) {
  const auto found = std::ranges::find(clip.weights, weight, &WeightCurve::weight);
  return found == clip.weights.end() ? 0 : sample(found->curve, seconds);
}

double mixed(double a, double b, double share) { return a + (b - a) * share; }
Vector mixed(const Vector& a, const Vector& b, double share) {
  return {mixed(a[0], b[0], share), mixed(a[1], b[1], share), mixed(a[2], b[2], share)};
}
Placement mixed(const Placement& a, const Placement& b, double share) {
  return {mixed(a.translation, b.translation, share), between(unit(a.rotation), unit(b.rotation), share),
          mixed(a.scale, b.scale, share)};
}

/// Returns a value `seconds` after the start of step `i`. value_of(clip, seconds): that of a clip alone.
template <class ValueOf>
auto faded(std::span<const ClipStep> steps, std::size_t i, double seconds, const ValueOf& value_of) {
  const ClipStep& step = steps[i];
  const auto own = value_of(*step.clip, time_in(*step.clip, seconds));
  if (seconds >= step.fade) return own;
  const ClipStep& before = steps[(i + steps.size() - 1) % steps.size()];
  return mixed(value_of(*before.clip, time_in(*before.clip, before.seconds + seconds)), own, seconds / step.fade);
}

}  // namespace

NodeAnimation joined_clips(const NodeTree& tree, std::span<const ClipStep> steps) {
  NodeAnimation joined;
  std::set<std::int32_t> nodes;
  std::set<std::uint32_t> weights;
  std::vector<std::pair<std::size_t, double>> times;  // a step, and seconds after its start
  std::vector<double> starts;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    for (const NodeCurves& curves : steps[i].clip->moved) nodes.insert(curves.node);
    for (const WeightCurve& curve : steps[i].clip->weights) weights.insert(curve.weight);
    starts.push_back(joined.duration);
    const bool next_jumps = steps[(i + 1) % steps.size()].fade == 0;
    const double last = steps[i].seconds - (next_jumps ? std::min(kJump, steps[i].seconds / 2) : 0);
    const double count = std::ceil(last * kValuesPerSecond);
    for (double k = 0; k < count; ++k) times.emplace_back(i, last * k / count);
    if (next_jumps || i + 1 == steps.size()) times.emplace_back(i, last);
    joined.duration += steps[i].seconds;
  }
  for (const std::int32_t node : nodes) {
    NodeCurves& curves = joined.moved.emplace_back();
    curves.node = node;
    for (const auto& [step, seconds] : times) {
      const Placement placement = faded(steps, step, seconds, [&](const NodeAnimation& clip, double time) {
        return tree.placement(clip, node, time);
      });
      for (std::vector<double>* const to : {&curves.translation.times, &curves.rotation.times, &curves.scale.times}) {
        to->push_back(starts[step] + seconds);
      }
      curves.translation.values.push_back(placement.translation);
      curves.rotation.values.push_back(placement.rotation);
      curves.scale.values.push_back(placement.scale);
    }
  }
  for (const std::uint32_t weight : weights) {
    Curve<std::array<double, 1>>& curve = joined.weights.emplace_back(WeightCurve{.weight = weight, .curve = {}}).curve;
    for (const auto& [step, seconds] : times) {
      curve.times.push_back(starts[step] + seconds);
      curve.values.push_back({faded(steps, step, seconds, [weight](const NodeAnimation& clip, double time) {
        return weight_of(clip, weight, time);
      })});
    }
  }
  return joined;
}

}  // namespace zstrip::sim
