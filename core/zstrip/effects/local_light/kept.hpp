// The data that a frame keeps for light that depends on a vertex's position.
#pragma once

#include "zstrip/effects/local_light/local_light.hpp"
#include "zstrip/state/frame_parts.hpp"

namespace zstrip::detail::local_light {

inline FrameLights& lights_of(const FrameState& frame) { return *effect_block(frame).at<Effect, FrameLights>(); }
inline InstanceShading& shading_of(const FrameState& frame, std::size_t instance) {
  return effect_block(frame).at<Effect, InstanceShading>(Effect::kFrameLightsBytes)[instance];
}

}  // namespace zstrip::detail::local_light
