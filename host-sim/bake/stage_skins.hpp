// The meshes of a stage that joints and morph targets move, and the flash of its scene.
#pragma once

#include <cstdint>

#include "bake/baked_scene.hpp"
#include "bake/flash_bytes.hpp"
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

/// Returns the flash of the scene without the program. `staging`: a frame of the stage.
inline std::uint64_t scene_flash(const Stage& stage, const Staging& staging) {
  if (stage.file_bytes() != 0) return stage.file_bytes();
  return flash_bytes(staging.scene, stage.animation(), staging.tree, skins_of(stage), staging.levels).total();
}

}  // namespace zstrip::sim
