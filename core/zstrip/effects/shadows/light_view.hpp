// The camera of a shadow map: shows all casters from a directional light, as large as possible.
#pragma once

#include "zstrip/camera.hpp"
#include "zstrip/geometry/instance.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/status.hpp"

namespace zstrip::detail {

/// The distances that the casters span along the map's right and up axes, and away from the light.
struct LightReach {
  Camera axes[3];  ///< at the origin; their viewing directions are the axes
  DistanceRange along[3]{kNoReach, kNoReach, kNoReach};

  explicit LightReach(const DirectionalLight& light);
  bool empty() const { return along[0].nearest > along[0].farthest; }
  /// `range_of(camera)` returns the DistanceRange of a caster.
  template <class RangeOf>
  void extend(const RangeOf& range_of) {
    for (int i = 0; i < 3; ++i) {
      const DistanceRange range = range_of(axes[i]);
      if (range.nearest < along[i].nearest) along[i].nearest = range.nearest;
      if (range.farthest > along[i].farthest) along[i].farthest = range.farthest;
    }
  }
};

/// Sets an orthographic camera with parallel rays from the light, for a picture of side x side pixels (16 or more). The
/// reach, which must not be empty, lies inside the picture with one pixel around it, and inside its depth range, which
/// is fixed. The right and up axes are shortened so that the reach fills the picture in both directions. Returns
/// Error::shadow if 16.16 is not enough.
Status light_camera(Camera& camera, const LightReach& reach, std::uint32_t side);

}  // namespace zstrip::detail
