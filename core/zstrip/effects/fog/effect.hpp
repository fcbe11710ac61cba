// Fog fades distant surfaces into one colour.
#pragma once

#include "zstrip/effects/effect.hpp"

namespace zstrip::detail::fog {

struct Effect : AnyEffect {
  static constexpr EffectName kNames[] = {
      {effect::fog, "fog", "the scene's fog"},
  };

  static constexpr Effects kNeedMemory = effect::fog;
  static constexpr std::uint32_t kAlignment = 8;
  static constexpr std::uint32_t kCurveBytes = 40;
  static constexpr std::uint64_t bytes(const SceneCounts&) { return kCurveBytes; }
};

}  // namespace zstrip::detail::fog
