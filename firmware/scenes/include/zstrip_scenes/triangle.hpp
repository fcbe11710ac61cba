// One triangle with a red, a green and a blue corner, seen from both sides.
#pragma once

#include "zstrip_scenes/built_in.hpp"
#include "zstrip_scenes/presentation.hpp"

namespace zstrip::scenes {

extern const Position kTrianglePositions[3];
extern const Colour kTriangleColours[3];
extern const Triangle kTriangleTriangles[1];

inline constexpr Mesh kTriangleMesh[] = {{.positions = kTrianglePositions,
                                          .normals = {},
                                          .colours = kTriangleColours,
                                          .texcoords = {},
                                          .triangles = kTriangleTriangles,
                                          .meshlets = {},
                                          .half_extent = {kFixedOne, kFixedOne, 0}}};
inline constexpr Material kTriangleMaterial[] = {{.lit = false, .smooth = true, .double_sided = true}};
inline constexpr Instance kTriangleInstance[] = {{}};

inline constexpr BuiltIn triangle{.name = "triangle",
                                  .description = "one triangle with three vertex colours, double-sided",
                                  .scene = {.meshes = kTriangleMesh,
                                            .materials = kTriangleMaterial,
                                            .textures = {},
                                            .instances = kTriangleInstance,
                                            .lights = {}},
                                  .counts = counts_of_one(kTriangleMesh[0], kTriangleMaterial[0]),
                                  .camera = turntable_camera(4.0, 20, 2.55),
                                  .focal_across = fixed(4.05)};

}  // namespace zstrip::scenes
