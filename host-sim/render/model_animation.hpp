// Converts a model file's animation to the renderer's, and lists the poses that a camera must show.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "import/model.hpp"
#include "motion/fitted_animation.hpp"
#include "motion/fitted_weights.hpp"
#include "result.hpp"
#include "zstrip/clips.hpp"

namespace zstrip::sim {

/// Returns the animation of this name; without a name the first one, or null if there is none. The failure lists the
/// animations of the file.
Result<const NodeAnimation*> find_animation(const Model& model, const std::optional<std::string>& name);

/// Returns the map from a moved instance's place at rest to its place at this time, in the file's units.
Affine moved_from_rest(const Model& model, const NodeAnimation& animation, std::int32_t node, double seconds);

/// Returns the eight corners of a box.
std::vector<Vector> corners_of_box(const Vector& low, const Vector& high);
/// Returns the eight corners of the box around a mesh, in object space.
std::vector<Vector> corners_of(const Mesh& mesh);

/// Converts the animation of the instances, in the model's scene units. The failure's message starts with a verb.
Result<FittedAnimation> fit_model_animation(const Model& model, const NodeAnimation& animation);

/// Converts the animation of the model's joints, which its tracks refer to. The failure's message starts with a verb.
/// `tolerance`: the largest distance of a vertex from its place, in the model's scene units.
Result<FittedAnimation> fit_joint_animation(const Model& model, const NodeAnimation& animation,
                                            double tolerance = kAnimationTolerance);

/// Converts the animation of the model's weights; else as fit_joint_animation.
Result<FittedWeights> fit_weight_animation(const Model& model, const NodeAnimation& animation,
                                           double tolerance = kAnimationTolerance);

/// Returns the events of an animation of `duration` milliseconds in their order, one a time; later ones are left out.
std::vector<ClipEvent> fit_events(std::span<const AnimationEvent> events, std::uint32_t duration);

/// Returns the instances at many times of the animation, one time after the other: all poses that a camera must show.
/// Returns `instances` if there are no tracks.
std::vector<Instance> all_poses(const Animation& animation, std::span<const Instance> instances);

}  // namespace zstrip::sim
