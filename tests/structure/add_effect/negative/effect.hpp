// A made-up effect, which add_effect.sh adds: the picture's negative.
#pragma once

#include "zstrip/effects/effect.hpp"

namespace zstrip::detail::negative {

struct Effect : AnyEffect {
  static constexpr EffectName kNames[] = {
      {effect::negative, "negative", "the scene's negative is asked for"},
  };

  static constexpr Effects kNeedMemory = effect::negative;
  static constexpr std::uint64_t bytes(const SceneCounts&) { return sizeof(std::uint32_t); }
};

}  // namespace zstrip::detail::negative
