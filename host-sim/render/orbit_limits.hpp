// How far the user of a window or a page may move a scene's camera.
#pragma once

namespace zstrip::sim {

struct OrbitLimits {
  struct Range {
    double least, most;
  };
  Range yaw{-360, 360}, pitch{-360, 360};  ///< degrees, from where the camera stands; they contain 0
  Range distance{0, 1e9};                  ///< factors; they contain 1
  double target = 0;                       ///< distance from the camera to the point that it moves around, in scene
                                           ///< units; 0: as orbited() finds the point
};

}  // namespace zstrip::sim
