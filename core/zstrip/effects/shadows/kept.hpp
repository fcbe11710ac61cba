// The place of a frame's shadow.
#pragma once

#include "zstrip/effects/shadows/shadow_map.hpp"
#include "zstrip/state/frame_parts.hpp"

namespace zstrip::detail::shadows {

inline ShadowState& state_of(const FrameState& frame) { return *effect_block(frame).at<Effect, ShadowState>(); }

}  // namespace zstrip::detail::shadows
