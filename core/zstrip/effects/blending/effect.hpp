// Blends instances with the colours behind them.
#pragma once

#include "zstrip/effects/effect.hpp"

namespace zstrip::detail::blending {

struct Effect : AnyEffect {
  static constexpr EffectName kNames[] = {
      {effect::blending, "blending", "the alpha mode blend"},
  };

  static constexpr Effects kNeedMemory = effect::blending;
  static constexpr std::uint32_t kAlignment = 8;
  static constexpr std::uint32_t kPlaceBytes = 16;  ///< bytes of an instance in the drawing order
  static constexpr std::uint64_t bytes(const SceneCounts& counts) {
    return std::uint64_t{counts.instances} * kPlaceBytes;
  }
};

}  // namespace zstrip::detail::blending
