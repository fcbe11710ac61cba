// Constructive solid geometry: solids are intersected, or cut out of each other.
#pragma once

#include "zstrip/effects/effect.hpp"

namespace zstrip::detail::csg {

struct Effect : AnyEffect {
  static constexpr EffectName kNames[] = {
      {effect::csg, "csg", "constructive solid geometry"},
  };

  static constexpr Effects kNeedMemory = effect::csg;
  static constexpr std::uint32_t kAlignment = 8;
  static constexpr std::uint32_t kStateBytes = 8;
  static constexpr std::uint32_t kOperandBytes = 16;
  static constexpr std::uint64_t bytes(const SceneCounts& counts) {
    return kStateBytes + std::uint64_t{counts.csg_operands} * kOperandBytes;
  }
};

}  // namespace zstrip::detail::csg
