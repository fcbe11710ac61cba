// What outlines add to the bounds of a frame.
#pragma once

#include "zstrip/effects/outlines/outline.hpp"
#include "zstrip/frame/effect_block.hpp"

namespace zstrip::detail {

/// Extends a reach by the hulls. `view`: of samples where there are several.
void extend_by_outlines(DistanceRange& reach, const OutlinedScene& outlined, const Camera& camera, const View& view);

}  // namespace zstrip::detail
