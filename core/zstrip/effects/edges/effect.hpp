// Anti-aliases the edges of meshes alone, without samples.
#pragma once

#include "zstrip/effects/effect.hpp"

namespace zstrip::detail::edges {

struct Effect : AnyEffect {
  static constexpr EffectName kNames[] = {
      {effect::edges, "edges", "edges are anti-aliased (--edges)"},
  };
  static constexpr Exclusion kExclusions[] = {
      {effect::edges, effect::depth_formats | effect::depth_ranges, "edges are compared with the codes of z16"},
  };

  static constexpr Effects kNeedMemory = effect::edges;
  static constexpr std::uint32_t kAlignment = 8;
  static constexpr std::uint32_t kStateBytes = 8;
  static constexpr std::uint32_t kGroupBytes = 5;
  static constexpr std::uint64_t bytes(const SceneCounts& counts) {
    return kStateBytes + std::uint64_t{counts.edge_groups} * kGroupBytes;
  }
};

}  // namespace zstrip::detail::edges
