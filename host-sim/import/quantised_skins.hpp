// Converts skins to fixed point: the box that holds a mesh in every pose, the joints, and the mesh at rest.
#pragma once

#include <optional>
#include <vector>

#include "import/model.hpp"
#include "import/source_box.hpp"
#include "import/source_model.hpp"

namespace zstrip::sim {

/// Returns the maps from all joints to the file's coordinates; `animation`: null at rest.
std::vector<Affine> joint_places(const SourceModel& source, const NodeAnimation* animation, double seconds);

/// Returns the box of a mesh with a skin: as it was modelled, at rest, and at many times of every animation. The box of
/// each joint's vertices is moved with the joint, so that a pose between these times can leave the box only by the
/// joint's motion within 1/60 s.
SourceBox box_of_poses(const SourceModel& source, const SourceMesh& mesh);

/// Returns the map from a joint to its parent, or to the scene; `animation`: null at rest. In scene units.
Affine local_of(const Model& model, std::size_t joint, const NodeAnimation* animation, double seconds);

/// Sets the model's joints, and writes its meshes with skins in the pose at rest. `model.skins`, tree and units must be
/// set. The failure's message starts with a verb.
Result<Done> set_joints(const SourceModel& source, Model& model);

}  // namespace zstrip::sim
