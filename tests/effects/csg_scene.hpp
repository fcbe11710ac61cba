// A knot, less what another knot cuts out of it.
#pragma once

#include "zstrip_scenes/knot.hpp"

namespace zstrip::scenes {

inline constexpr Instance kCutKnots[2] = {
    knot_lit.scene.instances[0],
    {0, 0, {{{0, 0, kFixedOne, 0}, {kFixedOne, 0, 0, kFixedOne / 8}, {0, kFixedOne, 0, 0}}}}};
inline constexpr CsgOperand kKnotLessKnot[2] = {{0, 0, CsgUse::intersected}, {1, 0, CsgUse::subtracted}};

inline constexpr BuiltIn csg = [] {
  BuiltIn scene = knot_lit;
  scene.name = "csg";
  scene.scene.instances = kCutKnots;
  scene.scene.csg = kKnotLessKnot;
  scene.counts = count(scene.scene);
  return scene;
}();

}  // namespace zstrip::scenes
