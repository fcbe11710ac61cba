// The place of a frame's fog.
#pragma once

#include "zstrip/effects/fog/effect.hpp"
#include "zstrip/effects/fog/fog.hpp"
#include "zstrip/state/frame_parts.hpp"

namespace zstrip::detail::fog {

static_assert(sizeof(FogCurve) == Effect::kCurveBytes);

inline FogCurve* curve_of(const FrameState& frame) { return effect_block(frame).at<Effect, FogCurve>(); }

}  // namespace zstrip::detail::fog
