// A set of lines prepared for one frame.
#pragma once

#include "zstrip/geometry/distance.hpp"
#include "zstrip/geometry/instance.hpp"

namespace zstrip::detail {

struct CompiledLines {
  CompiledInstance instance;  ///< what an instance of its mesh would be; the shading does not count
  Rect box;                   ///< raster pixels that it can cover, cut to the view
};
static_assert(sizeof(CompiledLines) <= kLineSetBytes);

/// Extends a reach by each set that lies in the camera's depth range.
void extend_by_lines(DistanceRange& reach, const Scene& scene, const Camera& camera);

}  // namespace zstrip::detail
