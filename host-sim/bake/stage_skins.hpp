// The meshes of a stage that joints move.
#pragma once

#include "bake/baked_scene.hpp"
#include "import/model.hpp"
#include "render/stage.hpp"

namespace zstrip::sim {

/// Valid as long as the stage.
inline BakedSkins skins_of(const Stage& stage) {
  const Model* const model = stage.model();
  if (!stage.bends() || model == nullptr) return {};
  return {model->skins, model->joints, model->rest, stage.joint_animation()};
}

}  // namespace zstrip::sim
