// Makes the BSP tree of a scene, and rotates the scene as a baked one is rotated.
#include "visibility/tree_stage.hpp"

#include <utility>

#include "render/turned_parts.hpp"
#include "visibility/prepared_scene.hpp"

namespace zstrip::sim {
namespace {

class TreeStage : public Stage {
 public:
  TreeStage(std::shared_ptr<const Stage> original, PreparedScene prepared, const Turn& turn)
      : original_(std::move(original)), prepared_(std::move(prepared)), turn_(turn) {}

  Result<Staging> place(std::uint32_t frame, std::uint32_t frames) override {
    const Staging rest = prepared_.staging();
    Result<Staging> placed = parts_.place({rest.scene, rest.camera, {}, turn_}, rest.tree, frame, frames);
    if (placed) placed->splits = prepared_.splits();
    return placed;
  }
  Result<Camera> camera(std::uint32_t frames) const override { return original_->camera(frames); }
  std::unique_ptr<Stage> copy() const override { return std::make_unique<TreeStage>(original_, prepared_, turn_); }
  const std::vector<std::string>& warnings() const override { return original_->warnings(); }
  OrbitLimits orbit_limits() const override { return original_->orbit_limits(); }
  Turn turn() const override { return turn_; }
  Origins origins() const override { return original_->origins(); }
  const Model* model() const override { return original_->model(); }

 private:
  std::shared_ptr<const Stage> original_;  ///< `prepared_` refers to its scene
  PreparedScene prepared_;
  Turn turn_;
  TurnedParts parts_;
};

}  // namespace

std::optional<Turn> turn_of_tree(const Stage& stage, std::size_t instances) {
  if (!stage.animation().tracks.empty() || stage.bends()) return std::nullopt;
  const Turn turn = stage.turn();
  if (turn.what == Turning::nothing || turn.what == Turning::camera) return turn;
  if (turn.still_instances == 0) return Turn{.what = Turning::instances};
  if (turn.still_instances >= instances) return Turn{.what = Turning::nothing};
  return std::nullopt;
}

Result<std::unique_ptr<Stage>> with_tree(std::unique_ptr<Stage> stage, std::uint32_t frames) {
  const Result<Staging> rest = stage->place(0, frames);
  if (!rest) return rest.failure();
  const std::optional<Turn> turn = turn_of_tree(*stage, rest->scene.instances.size());
  if (!turn || !rest->tree.nodes.empty()) return stage;
  Result<PreparedScene> prepared = PreparedScene::of(*rest, method::painter | method::bsp);
  if (!prepared) return prepared.failure();
  return std::unique_ptr<Stage>(
      std::make_unique<TreeStage>(std::shared_ptr<const Stage>(std::move(stage)), std::move(*prepared), *turn));
}

}  // namespace zstrip::sim
