// Pipelines of visibility methods as a device would have them: nothing is counted and culling cannot be switched.
#pragma once

#include "zstrip/frame/pipeline.hpp"

namespace zstrip::sim {

/// Draws what pipeline_for(effects) draws. Where the method has none without counts (orthographic cameras, culling,
/// orders of the host's, effects of fragments, of local light and of surfaces) it is that one.
Pipeline uncounted_pipeline(Effects effects);

}  // namespace zstrip::sim
