// Prepares the sets of lines of a frame, before its strips.
#pragma once

#include "zstrip/effects/lines/lines.hpp"
#include "zstrip/state/frame_parts.hpp"

namespace zstrip::detail::lines {

void extend(DistanceRange& reach, const Scene& scene, const Camera& camera);
/// Compiles the sets of lines. The frame still has the depth mapping of z16; DepthStage later changes both.
Status prepare(FrameState& frame, const Scene& scene, const Camera& camera);

}  // namespace zstrip::detail::lines
