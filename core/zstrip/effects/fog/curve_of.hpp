// Where the fog of a frame is kept.
#pragma once

#include "zstrip/effects/fog/effect.hpp"
#include "zstrip/effects/fog/fog.hpp"
#include "zstrip/stages/frame_parts.hpp"

namespace zstrip::detail::fog {

static_assert(sizeof(FogCurve) == Effect::kCurveBytes);

/// Of a frame whose scene has fog.
inline FogCurve* curve_of(const FrameState& frame) { return effect_block(frame).at<Effect, FogCurve>(); }

}  // namespace zstrip::detail::fog
