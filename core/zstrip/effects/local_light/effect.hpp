// Light that depends on the position of a vertex.
#pragma once

#include "zstrip/effects/effect.hpp"

namespace zstrip::detail::local_light {

struct Effect : AnyEffect {
  static constexpr EffectName kNames[] = {
      {effect::emissive, "emissive", "an emissive colour"},
      {effect::specular, "specular", "a specular colour"},
      {effect::punctual_lights, "punctual_lights", "lit, and there are point or spot lights"},
  };

  static constexpr Effects kNeedMemory = effect::local_light;
  static constexpr std::uint32_t kFrameLightsBytes = 192;
  static constexpr std::uint32_t kWorldLightBytes = 44;
  static constexpr std::uint32_t kShadingBytes = 68;
  static constexpr std::uint64_t bytes(const SceneCounts& counts) {
    return kFrameLightsBytes + std::uint64_t{counts.instances} * kShadingBytes;
  }
};

}  // namespace zstrip::detail::local_light
