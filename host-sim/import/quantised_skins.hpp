// Skins in fixed point: the box that holds a mesh in every pose, the joints, and the mesh as it is at rest.
#pragma once

#include <optional>
#include <vector>

#include "import/model.hpp"
#include "import/source_model.hpp"

namespace zstrip::sim {

/// The file's units.
struct SourceBox {
  std::array<double, 3> low{}, high{};
};

/// All of a mesh with a skin, as it was modelled, at rest, and at many times of every animation; boxes of what each
/// joint moves are moved with it, so that nothing between leaves it but by what a joint does within 1/60 s.
SourceBox box_of_poses(const SourceModel& source, const SourceMesh& mesh);

/// From a joint to its parent, or to the scene; `animation`: null at rest. In scene units.
Affine local_of(const Model& model, std::size_t joint, const NodeAnimation* animation, double seconds);

/// Fills the model's joints, and writes its meshes with skins as they are at rest. `model.skins`, its tree and units
/// are there. The failure's message starts with a verb.
Result<Done> set_joints(const SourceModel& source, Model& model);

}  // namespace zstrip::sim
