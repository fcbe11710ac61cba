// A stage over another one, which answers all that it does not change.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "render/stage.hpp"

namespace zstrip::sim {

/// Derived classes change what the other stage places.
class StageOver : public Stage {
 public:
  explicit StageOver(std::unique_ptr<Stage> stage) : stage_(std::move(stage)) {}

  Result<Camera> camera(std::uint32_t frames) const override { return stage_->camera(frames); }
  const std::vector<std::string>& warnings() const override { return stage_->warnings(); }
  Animation animation() const override { return stage_->animation(); }
  bool bends() const override { return stage_->bends(); }
  const Model* bent() const override { return stage_->bent(); }
  Animation joint_animation() const override { return stage_->joint_animation(); }
  Result<std::vector<ModelClip>> clips() const override { return stage_->clips(); }
  WeightAnimation weight_animation() const override { return stage_->weight_animation(); }
  std::vector<ClipEvent> events() const override { return stage_->events(); }
  OrbitLimits orbit_limits() const override { return stage_->orbit_limits(); }
  Turn turn() const override { return stage_->turn(); }
  Origins origins() const override { return stage_->origins(); }
  const Model* model() const override { return stage_->model(); }
  const SceneBlob* blob() const override { return stage_->blob(); }

 protected:
  Stage& under() const { return *stage_; }

 private:
  std::unique_ptr<Stage> stage_;
};

}  // namespace zstrip::sim
