// A model file's animation as the renderer's, and what a camera must see of one.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "import/model.hpp"
#include "motion/fitted_animation.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// The animation of this name; without a name the first, or null if there is none. A failure lists those of the file.
Result<const NodeAnimation*> find_animation(const Model& model, const std::optional<std::string>& name);

/// Where a moved instance of the model is, from where it is at rest, in the file's units.
Affine moved_from_rest(const Model& model, const NodeAnimation& animation, std::int32_t node, double seconds);

/// The eight corners of the box around a mesh, in object space.
std::vector<Vector> corners_of(const Mesh& mesh);

/// In the model's scene units. The failure's message starts with a verb.
Result<FittedAnimation> fit_model_animation(const Model& model, const NodeAnimation& animation);

/// Of the model's joints: tracks name these. Likewise.
Result<FittedAnimation> fit_joint_animation(const Model& model, const NodeAnimation& animation);

/// The instances as they are at many times of the animation, one after the other: what a camera must see of it. Without
/// tracks, those given.
std::vector<Instance> all_poses(const Animation& animation, std::span<const Instance> instances);

}  // namespace zstrip::sim
