// A triangle of a few pixels as a billboard: what it costs is that it is turned.
#pragma once

#include "zstrip_scenes/triangle.hpp"

namespace zstrip::scenes {

inline constexpr Mesh kBillboardMeshes[1] = {[] {
  Mesh mesh = triangle.scene.meshes[0];
  mesh.billboard = Billboard::viewer;
  return mesh;
}()};
inline constexpr Instance kBillboardInstances[1] = {
    {.transform = {{{fixed(0.05), 0, 0, 0}, {0, fixed(0.05), 0, 0}, {0, 0, fixed(0.05), 0}}}}};

inline constexpr BuiltIn billboards = [] {
  BuiltIn scene = triangle;
  scene.name = "billboards";
  scene.scene.meshes = kBillboardMeshes;
  scene.scene.instances = kBillboardInstances;
  return scene;
}();

}  // namespace zstrip::scenes
