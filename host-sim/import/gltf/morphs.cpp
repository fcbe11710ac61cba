// Weights of morph targets in a glTF file.
#include "import/gltf/morphs.hpp"

#include <algorithm>
#include <cmath>

#include "import/gltf/document.hpp"

namespace zstrip::sim {
namespace {

/// Weights of the renderer end at 8; a weight of 7 keeps room for splines.
constexpr double kMaxWeight = 7;
/// Places between two keys at which a spline's range is measured.
constexpr int kSteps = 16;

template <class Visit>
void for_each_value(const Curve<GltfMorphs::Weight>& curve, const Visit& visit) {
  for (std::size_t i = 0; i < curve.times.size(); ++i) {
    visit(curve.values[i][0]);
    if (curve.interpolation != Interpolation::cubic_spline || i + 1 == curve.times.size()) continue;
    for (int k = 1; k < kSteps; ++k) {
      visit(sample(curve, curve.times[i] + (curve.times[i + 1] - curve.times[i]) * k / kSteps));
    }
  }
}

void scale(std::vector<GltfMorphs::Weight>& values, double by) {
  for (GltfMorphs::Weight& value : values) value[0] *= by;
}

}  // namespace

const GltfJson& GltfMorphs::mesh_of(std::size_t node) const {
  const std::optional<std::size_t> index = index_in(element(member(json_, "nodes"), node), "mesh");
  return element(member(json_, "meshes"), index.value_or(static_cast<std::size_t>(-1)));
}

std::size_t GltfMorphs::targets_of(std::size_t node) const {
  const GltfJson& mesh = mesh_of(node);
  std::size_t most = 0;
  for (std::size_t i = 0; i < count_of(mesh, "primitives"); ++i) {
    most = std::max(most, count_of(element(member(mesh, "primitives"), i), "targets"));
  }
  return most;
}

double GltfMorphs::at_rest(std::size_t node, std::size_t target) const {
  const GltfJson& own = member(element(member(json_, "nodes"), node), "weights");
  const double weight = to_number(element(own.is_array() ? own : member(mesh_of(node), "weights"), target), 0);
  return std::isfinite(weight) ? weight : 0;
}

Result<Done> GltfMorphs::add(std::size_t node, std::vector<Curve<Weight>> curves, NodeAnimation& animation) {
  for (std::size_t target = 0; target < curves.size(); ++target) {
    const double rest = at_rest(node, target);
    bool changes = false;
    for_each_value(curves[target], [&](double value) { changes = changes || std::abs(value - rest) > 1e-6; });
    if (curves[target].times.empty()) continue;
    const bool known = moved_.contains({node, target});
    if (!changes && !known) continue;
    if (!known) {
      if (rest_.size() >= 0xFFFF) return gltf_damaged("animations change more than 65,535 weights of morph targets");
      moved_[{node, target}] = static_cast<std::uint32_t>(rest_.size());
      rest_.push_back(rest);
      places_.push_back(0);
    }
    const std::uint32_t weight = moved_[{node, target}];
    // An earlier channel of this animation may have the same weight. A place that another animation left has another
    // weight here, or none.
    std::size_t& at = places_[weight];
    if (at < animation.weights.size() && animation.weights[at].weight == weight) {
      animation.weights[at].curve = std::move(curves[target]);
    } else {
      at = animation.weights.size();
      animation.weights.push_back({weight, std::move(curves[target])});
    }
  }
  return Done{};
}

void GltfMorphs::finish(SourceModel& model) {
  model.weights.clear();
  for (const double rest : rest_) {
    model.weights.push_back({.low = std::min(0.0, -rest), .high = std::max(0.0, 1 - rest)});
  }
  const auto for_each_curve = [&model](const auto& visit) {
    for (NodeAnimation& animation : model.nodes.animations) {
      for (WeightCurve& each : animation.weights) visit(each.weight, each.curve);
    }
  };
  for_each_curve([&](std::uint32_t index, Curve<Weight>& curve) {
    for (Weight& value : curve.values) value[0] -= rest_[index];
    SourceWeight& range = model.weights[index];
    for_each_value(curve, [&](double value) {
      range.low = std::min(range.low, value);
      range.high = std::max(range.high, value);
    });
  });
  for (SourceWeight& range : model.weights) {
    const double largest = std::max(-range.low, range.high);
    scale_.push_back(largest > kMaxWeight ? largest / kMaxWeight : 1);
    range.low /= scale_.back();
    range.high /= scale_.back();
  }
  for_each_curve([&](std::uint32_t index, Curve<Weight>& curve) {
    for (auto* values : {&curve.values, &curve.slopes_in, &curve.slopes_out}) scale(*values, 1 / scale_[index]);
  });
}

std::optional<GltfMorphs::Moved> GltfMorphs::moved(std::size_t node, std::size_t target) const {
  const auto at = moved_.find({node, target});
  if (at == moved_.end() || at->second >= scale_.size()) return std::nullopt;
  return Moved{at->second, scale_[at->second]};
}

}  // namespace zstrip::sim
