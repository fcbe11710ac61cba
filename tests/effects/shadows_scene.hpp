// The knot in its own shadow.
#pragma once

#include "zstrip_scenes/knot.hpp"

namespace zstrip::scenes {

inline constexpr Shadow kKnotShadow[1] = {{.log2_size = 7, .pool = 12000}};

inline constexpr BuiltIn shadows = [] {
  BuiltIn scene = knot_lit;
  scene.name = "shadows";
  scene.scene.shadow = kKnotShadow;
  scene.counts = count(scene.scene);
  return scene;
}();

}  // namespace zstrip::scenes
