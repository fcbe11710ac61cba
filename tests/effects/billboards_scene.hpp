// The knot as a billboard: the same side of it from everywhere.
#pragma once

#include "zstrip_scenes/knot.hpp"

namespace zstrip::scenes {

inline constexpr Mesh kKnotBillboard[1] = {[] {
  Mesh mesh = knot.scene.meshes[0];
  mesh.billboard = Billboard::viewer;
  return mesh;
}()};

inline constexpr BuiltIn billboards = [] {
  BuiltIn scene = knot;
  scene.name = "billboards";
  scene.scene.meshes = kKnotBillboard;
  return scene;
}();

}  // namespace zstrip::scenes
