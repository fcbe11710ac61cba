// Sets of lines of a frame, as they are prepared before its strips.
#pragma once

#include "zstrip/effects/lines/lines.hpp"
#include "zstrip/stages/frame_parts.hpp"

namespace zstrip::detail::lines {

/// Extends a reach by each set that lies in the camera's depth range.
void extend(DistanceRange& reach, const Scene& scene, const Camera& camera);
/// Compiles the sets of lines. The frame has the depth mapping of z16, whatever its format: DepthStage changes both.
Status prepare(FrameState& frame, const Scene& scene, const Camera& camera);

}  // namespace zstrip::detail::lines
