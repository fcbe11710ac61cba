// Shadows: a map of depths is drawn from the light.
#pragma once

#include "zstrip/effects/effect.hpp"
#include "zstrip/scene/parts.hpp"

namespace zstrip::detail::shadows {

struct Effect : AnyEffect {
  static constexpr EffectName kNames[] = {
      {effect::shadows, "shadows", "the shadow of a light, and something is lit"},
  };
  static constexpr Exclusion kExclusions[] = {
      {effect::shadows, effect::depth_ranges, "a shadow is found by what a depth code stands for"},
  };

  static constexpr Effects kNeedMemory = effect::shadows;
  static constexpr std::uint32_t kAlignment = 8;
  /// The frame's shadow with its scene, and decoded tiles of its map.
  static constexpr std::uint32_t kStateBytes = scene_bytes(8) + 2432;
  static constexpr std::uint64_t bytes(const SceneCounts& counts) {
    return std::uint64_t{kStateBytes} + counts.shadow_pool;
  }
};

}  // namespace zstrip::detail::shadows
