// Prepares a scene on the host before a method can draw it: a tree for painter-bsp, an order for painter-newell.
#pragma once

#include <memory>

#include "render/stage.hpp"
#include "result.hpp"
#include "visibility/bsp_bake.hpp"
#include "zstrip/effects.hpp"

namespace zstrip::sim {

/// Owns the data that it makes; equals the original scene if the method needs no preparation. `original` must outlive
/// it.
class PreparedScene {
 public:
  /// Also a usage error if the method cannot draw features of the scene.
  static Result<PreparedScene> of(const Staging& original, Effects method);

  /// Returns the scene with the tree of method::bsp, which lives as long as this object or `original`.
  Staging staging() const { return made_ ? Staging{made_->scene.scene(), original_.camera, made_->tree()} : original_; }
  /// Returns the number of triangles that were split.
  std::size_t splits() const { return made_ ? made_->splits : original_.splits; }

 private:
  explicit PreparedScene(const Staging& original) : original_(original) {}

  Staging original_;
  std::shared_ptr<const BakedBsp> made_;  ///< without nodes for painter-newell
};

}  // namespace zstrip::sim
