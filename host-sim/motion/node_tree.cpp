// The nodes of a model that its animations move.
#include "motion/node_tree.hpp"

#include <algorithm>

namespace zstrip::sim {
namespace {

template <std::size_t count>
std::array<double, count> linear(const std::array<double, count>& a, const std::array<double, count>& b, double share) {
  std::array<double, count> result{};
  for (std::size_t i = 0; i < count; ++i) result[i] = a[i] + (b[i] - a[i]) * share;
  return result;
}
Quaternion linear(const Quaternion& a, const Quaternion& b, double share) { return between(unit(a), unit(b), share); }

template <std::size_t count>
std::array<double, count> finished(const std::array<double, count>& v) {
  return v;
}
Quaternion finished(const Quaternion& q) { return unit(q); }

/// Hermite's cubic, as glTF 2.0 (appendix C) writes it.
template <typename Value>
Value cubic(const Curve<Value>& curve, std::size_t k, double share) {
  const double length = curve.times[k + 1] - curve.times[k];
  const double s = share, s2 = s * s, s3 = s2 * s;
  Value result{};
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = (2 * s3 - 3 * s2 + 1) * curve.values[k][i] + length * (s3 - 2 * s2 + s) * curve.slopes_out[k][i] +
                (3 * s2 - 2 * s3) * curve.values[k + 1][i] + length * (s3 - s2) * curve.slopes_in[k + 1][i];
  }
  return finished(result);
}

template <typename Value>
Value sample_any(const Curve<Value>& curve, double seconds) {
  const auto after = std::upper_bound(curve.times.begin(), curve.times.end(), seconds);
  if (after == curve.times.begin()) return finished(curve.values.front());
  const auto k = static_cast<std::size_t>(after - curve.times.begin() - 1);
  if (after == curve.times.end() || curve.interpolation == Interpolation::step) return finished(curve.values[k]);
  const double share = (seconds - curve.times[k]) / (curve.times[k + 1] - curve.times[k]);
  if (curve.interpolation == Interpolation::cubic_spline) return cubic(curve, k, share);
  return linear(curve.values[k], curve.values[k + 1], share);
}

const NodeCurves* curves_of(const NodeAnimation& animation, std::int32_t node) {
  const auto at = std::ranges::find(animation.moved, node, &NodeCurves::node);
  return at == animation.moved.end() ? nullptr : &*at;
}

const Node& node_at(const NodeTree& tree, std::int32_t index) { return tree.nodes[static_cast<std::size_t>(index)]; }

Placement placement_of(const Node& node, const NodeCurves* curves, double seconds) {
  Placement placement = node.parts ? *node.parts : to_placement(node.at_rest);
  if (curves == nullptr) return placement;
  if (!curves->translation.times.empty()) placement.translation = sample(curves->translation, seconds);
  if (!curves->rotation.times.empty()) placement.rotation = sample(curves->rotation, seconds);
  if (!curves->scale.times.empty()) placement.scale = sample(curves->scale, seconds);
  return placement;
}

Affine placed(const Node& node, const NodeCurves* curves, double seconds) {
  return curves == nullptr ? node.at_rest : to_affine(placement_of(node, curves, seconds));
}

}  // namespace

Vector sample(const Curve<Vector>& curve, double seconds) { return sample_any(curve, seconds); }
Quaternion sample(const Curve<Quaternion>& curve, double seconds) { return sample_any(curve, seconds); }
double sample(const Curve<std::array<double, 1>>& curve, double seconds) { return sample_any(curve, seconds)[0]; }

Affine NodeTree::at_rest(std::int32_t node) const {
  Affine world;
  for (; node != kNoNode; node = node_at(*this, node).parent) {
    world = local(nullptr, node, 0) * world;
  }
  return world;
}

Affine NodeTree::at(const NodeAnimation& animation, std::int32_t node, double seconds) const {
  Affine world;
  for (; node != kNoNode; node = node_at(*this, node).parent) {
    world = local(&animation, node, seconds) * world;
  }
  return world;
}

Affine NodeTree::local(const NodeAnimation* animation, std::int32_t node, double seconds) const {
  const Node& at = node_at(*this, node);
  return at.before * placed(at, animation == nullptr ? nullptr : curves_of(*animation, node), seconds);
}

Placement NodeTree::placement(const NodeAnimation& animation, std::int32_t node, double seconds) const {
  return placement_of(node_at(*this, node), curves_of(animation, node), seconds);
}

bool NodeTree::moves(const NodeAnimation& animation, std::int32_t node) const {
  while (node != kNoNode && curves_of(animation, node) == nullptr) node = node_at(*this, node).parent;
  return node != kNoNode;
}

std::set<double> key_times(const NodeAnimation& animation) {
  std::set<double> times;
  for (const NodeCurves& curves : animation.moved) {
    times.insert(curves.translation.times.begin(), curves.translation.times.end());
    times.insert(curves.rotation.times.begin(), curves.rotation.times.end());
    times.insert(curves.scale.times.begin(), curves.scale.times.end());
  }
  for (const WeightCurve& weight : animation.weights) {
    times.insert(weight.curve.times.begin(), weight.curve.times.end());
  }
  return times;
}

}  // namespace zstrip::sim
