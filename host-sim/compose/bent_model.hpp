// The motion of the one model of a scene file that bends, by joints or by morph targets.
#pragma once

#include <span>

#include "compose/composed_scene.hpp"
#include "compose/placed_model.hpp"
#include "compose/placed_part.hpp"
#include "compose/scene_file.hpp"
#include "result.hpp"

namespace zstrip::sim {

/// Sets the joints and weights of ComposedScene::bent, which has its skins and morph targets, and their motion, which
/// lasts `duration` seconds, as the scene's. `entry` and `placed`: the model. `parts`: all of the scene. Takes the
/// model's tree and joints away from ComposedScene::models.
Result<Done> bend(const SceneFile& file, const FileModel& entry, const PlacedModel& placed,
                  std::span<const PlacedPart> parts, double duration, ComposedScene& composed);

}  // namespace zstrip::sim
