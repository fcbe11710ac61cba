// What the host does to a scene before a method can draw it: a tree for painter-bsp, an order for painter-newell.
#pragma once

#include <memory>

#include "render/stage.hpp"
#include "result.hpp"
#include "visibility/bsp_bake.hpp"
#include "zstrip/effects.hpp"

namespace zstrip::sim {

/// Owns what it makes; where a method needs nothing, it is the scene as it was. `original` must outlive it.
class PreparedScene {
 public:
  /// A usage error also where the method cannot draw what the scene has.
  static Result<PreparedScene> of(const Staging& original, Effects method);

  /// With the tree of method::bsp, which lives as long as this or `original`.
  Staging staging() const { return made_ ? Staging{made_->scene.scene(), original_.camera, made_->tree()} : original_; }
  /// Triangles that were split.
  std::size_t splits() const { return made_ ? made_->splits : original_.splits; }

 private:
  explicit PreparedScene(const Staging& original) : original_(original) {}

  Staging original_;
  std::shared_ptr<const BakedBsp> made_;  ///< without nodes for painter-newell
};

}  // namespace zstrip::sim
