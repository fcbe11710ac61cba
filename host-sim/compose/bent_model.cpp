// The motion of the one model of a scene file that bends, by joints or by morph targets.
#include "compose/bent_model.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "compose/timeline.hpp"
#include "motion/clip_sequence.hpp"
#include "render/model_animation.hpp"

namespace zstrip::sim {
namespace {

/// The motion of a small model in a large scene is so many times coarser than alone, at most: the camera may be near.
constexpr double kMaxCoarseness = 16;

/// Durations that differ by less, in seconds, are the same in milliseconds.
constexpr double kSameDuration = 1e-4;

}  // namespace

Result<Done> bend(const SceneFile& file, const FileModel& entry, const PlacedModel& placed,
                  std::span<const PlacedPart> parts, double duration, ComposedScene& composed) {
  double largest = 0;  // length in the scene of a unit of the model
  for (const PlacedPart& part : parts) {
    if (part.bends()) {
      largest = std::max(largest, part.file->placement.scale[0] * composed.units.scale / placed.model->units.scale);
    }
  }
  Model& bent = composed.bent;
  bent.meshes = composed.meshes;
  // Moved, because copies take more code; placed.animation stays where it is. PlacedPart::bends() needs them before.
  Model& model = *std::ranges::find_if(composed.models, [&](const Model& each) { return &each == placed.model; });
  bent.joints = std::move(model.joints);
  bent.rest = std::move(model.rest);
  bent.joint_nodes = std::move(model.joint_nodes);
  bent.tree = std::move(model.tree);
  bent.weights = std::move(model.weights);
  bent.units = model.units;
  const NodeAnimation* animation = placed.animation;
  NodeAnimation repeated;
  if (std::abs(animation->duration - duration) > kSameDuration) {
    const ClipStep whole{.clip = animation, .seconds = duration};
    repeated = joined_clips(bent.tree, {&whole, 1});
    animation = &repeated;
  }
  const double tolerance = kAnimationTolerance * std::min(kComposedRadius / largest, kMaxCoarseness);
  const auto wrong = [&](const Failure& failure) {
    return at_line(file.path, entry.line, "[[model]]: the animation " + failure.message);
  };
  Result<FittedAnimation> joints = fit_joint_animation(bent, *animation, tolerance);
  if (!joints) return wrong(joints.failure());
  Result<FittedWeights> weights = fit_weight_animation(bent, *animation, tolerance);
  if (!weights) return wrong(weights.failure());
  composed.joint_animation = std::move(*joints);
  composed.weight_animation = std::move(*weights);
  return Done{};
}

}  // namespace zstrip::sim
