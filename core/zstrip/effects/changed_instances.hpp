// Rotated billboards, followed by hulls. They lie in the arena, because the caller's instances must not change.
#pragma once

#include "zstrip/effects/effect.hpp"

namespace zstrip::detail::changed_instances {

struct Memory : AnyEffect {
  static constexpr Effects kNeedMemory = effect::billboards | effect::outlines;
  static constexpr std::uint32_t kInstanceBytes = 52;
  static constexpr std::uint64_t bytes(const SceneCounts& counts) {
    return std::uint64_t{counts.instances} * kInstanceBytes;
  }
};

static_assert(sizeof(Instance) == Memory::kInstanceBytes);

}  // namespace zstrip::detail::changed_instances
