// Which depth format a picture needs, from the distances at which its things lie and how close together they are.
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
  double at_nearest, at_farthest;  ///< view units; what lies closer together is not sorted
};

struct DepthAdvice {
  double nearest = 0, farthest = 0;  ///< view units; where things are
  double needed = 0;                 ///< smallest separation that is to sort at the farthest
  std::vector<FormatSeparation> formats;
  DepthFormat advised = DepthFormat::z16;

  /// What the planner needs; `kept`: what the advice is for.
  DepthNeed need(const KeptFrames& kept) const;
};

/// Without a `separation` of the scene's things (view units): what lies one pixel behind something else, which is as
/// far apart as the picture can show.
DepthAdvice advise_depth(const KeptFrames& kept, const Camera& camera, const View& view,
                         std::optional<double> separation);

/// "z16", "float", "z24".
const char* name(DepthFormat format);

}  // namespace zstrip::sim
