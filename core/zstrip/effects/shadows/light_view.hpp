// The camera of a shadow map: how a directional light sees what casts shadows, all of it and as large as possible.
#pragma once

#include "zstrip/camera.hpp"
#include "zstrip/geometry/instance.hpp"
#include "zstrip/scene.hpp"
#include "zstrip/status.hpp"

namespace zstrip::detail {

/// How far what casts reaches along the map's right, its up, and away from the light.
struct LightReach {
  Camera axes[3];  ///< at the origin: distances from them are those along the axes
  DistanceRange along[3]{kNoReach, kNoReach, kNoReach};

  explicit LightReach(const DirectionalLight& light);
  bool empty() const { return along[0].nearest > along[0].farthest; }
  /// `range_of(camera)` is the DistanceRange of something that casts.
  template <class RangeOf>
  void extend(const RangeOf& range_of) {
    for (int i = 0; i < 3; ++i) {
      const DistanceRange range = range_of(axes[i]);
      if (range.nearest < along[i].nearest) along[i].nearest = range.nearest;
      if (range.farthest > along[i].farthest) along[i].farthest = range.farthest;
    }
  }
};

/// An orthographic camera with parallel rays from the light, for a picture of side x side pixels (16 or more): the
/// reach, which is not empty, lies inside it with a pixel around it, and inside its depth range, which is fixed. Its
/// axes right and up are shortened so that the picture is filled both ways. Error::shadow if that cannot be had
/// in 16.16.
Status light_camera(Camera& camera, const LightReach& reach, std::uint32_t side);

}  // namespace zstrip::detail
