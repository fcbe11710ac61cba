// Blending with what is behind.
#pragma once

#include "zstrip/effects/effect.hpp"

namespace zstrip::detail::blending {

struct Effect : AnyEffect {
  static constexpr EffectName kNames[] = {
      {effect::blending, "blending", "the alpha mode blend"},
  };

  static constexpr Effects kNeedMemory = effect::blending;
  static constexpr std::uint32_t kAlignment = 8;
  static constexpr std::uint32_t kPlaceBytes = 16;  ///< of an instance, in the order of drawing
  static constexpr std::uint64_t bytes(const SceneCounts& counts) {
    return std::uint64_t{counts.instances} * kPlaceBytes;
  }
};

}  // namespace zstrip::detail::blending
