// Outlines: hulls behind the instances that they outline.
#pragma once

#include "zstrip/effects/effect.hpp"
#include "zstrip/scene/parts.hpp"

namespace zstrip::detail::outlines {

struct Effect : AnyEffect {
  static constexpr EffectName kNames[] = {
      {effect::outlines, "outlines", "has an outline"},
  };

  static constexpr Effects kNeedMemory = effect::outlines;
  static constexpr std::uint32_t kAlignment = 8;
  static constexpr std::uint32_t kSceneBytes = scene_bytes(8) + 8;  ///< the scene with its hulls as instances
  static constexpr std::uint64_t bytes(const SceneCounts&) { return kSceneBytes; }
};

}  // namespace zstrip::detail::outlines
