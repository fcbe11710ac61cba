// The meshes of a stage that joints and morph targets move.
#pragma once

#include "bake/baked_scene.hpp"
#include "import/model.hpp"
#include "render/stage.hpp"

namespace zstrip::sim {

/// Valid as long as the stage.
inline BakedSkins skins_of(const Stage& stage) {
  const Model* const model = stage.bent();
  if (!stage.bends() || model == nullptr) return {};
  BakedSkins skins{model->skins, model->joints, model->rest, stage.joint_animation()};
  if (const WeightAnimation weights = stage.weight_animation(); !weights.tracks.empty()) {
    skins.morphs = model->morphs;
    skins.weights = model->weights.size();
    skins.weight_animation = weights;
  }
  return skins;
}

}  // namespace zstrip::sim
