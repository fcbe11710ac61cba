// Environment maps: textures that surfaces mirror.
#pragma once

#include "zstrip/effects/effect.hpp"

namespace zstrip::detail::environment {

struct Effect : AnyEffect {
  static constexpr EffectName kNames[] = {
      {effect::environment, "environment", "an environment map, with normals"},
  };

  static constexpr Effects kNeedMemory = effect::environment;
  static constexpr std::uint32_t kFrameBytes = 8;
  static constexpr std::uint32_t kEyeFormsBytes = 68;
  static constexpr std::uint64_t bytes(const SceneCounts& counts) {
    return kFrameBytes + std::uint64_t{counts.instances} * kEyeFormsBytes;
  }
};

}  // namespace zstrip::detail::environment
