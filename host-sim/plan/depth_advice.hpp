// Chooses the depth format of a picture from the distances of its surfaces, and from the separation between them.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "plan/kept_frames.hpp"
#include "zstrip/plan.hpp"
#include "zstrip/view.hpp"

namespace zstrip::sim {

struct FormatSeparation {
  DepthFormat format;
  double at_nearest, at_farthest;  ///< view units; surfaces that are closer together are not sorted
};

struct DepthAdvice {
  double nearest = 0, farthest = 0;  ///< view units; range of the surfaces
  double needed = 0;                 ///< smallest separation to be sorted, at the farthest surface
  std::vector<FormatSeparation> formats;
  DepthFormat advised = DepthFormat::z16;

  /// Returns the input of the planner; `kept`: the frames that the advice is for.
  DepthNeed need(const KeptFrames& kept) const;
};

/// Without a `separation` of the scene's surfaces (view units), the separation is the size of a pixel: surfaces closer
/// than that cannot be told apart in the picture.
DepthAdvice advise_depth(const KeptFrames& kept, const Camera& camera, const View& view,
                         std::optional<double> separation);

/// Returns "z16", "float" or "z24".
const char* name(DepthFormat format);

}  // namespace zstrip::sim
