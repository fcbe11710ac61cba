// The knot with an outline: its own hull, because its normals are those of a smooth surface.
#pragma once

#include "zstrip_scenes/knot.hpp"

namespace zstrip::scenes {

inline constexpr Outline kKnotOutline[1] = {{.colour = {0, 0, 40, 255}, .width = 40}};
inline constexpr Mesh kOutlinedKnot[1] = {[] {
  Mesh mesh = knot_lit.scene.meshes[0];
  mesh.outline = 1;
  return mesh;
}()};

inline constexpr BuiltIn outlines = [] {
  BuiltIn scene = knot_lit;
  scene.name = "outlines";
  scene.scene.meshes = kOutlinedKnot;
  scene.scene.outlines = kKnotOutline;
  scene.counts = count(scene.scene);
  return scene;
}();

}  // namespace zstrip::scenes
