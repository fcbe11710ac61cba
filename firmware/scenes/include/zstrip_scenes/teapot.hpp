// The Utah teapot, lit and smooth: y up, the spout towards +x, 2 units from spout to handle. Like Newell's data it is
// open at the spout's mouth, under the lid's edge, and where spout and handle enter the body.
#pragma once

#include "zstrip_scenes/built_in.hpp"
#include "zstrip_scenes/presentation.hpp"

namespace zstrip::scenes {

inline constexpr std::size_t kTeapotVertices = 529;
inline constexpr std::size_t kTeapotTriangleCount = 992;
inline constexpr Vec3 kTeapotHalfExtent{65538, 32116, 40782};  // 16.16: +-1 in x at grid 32767

extern const Position kTeapotPositions[kTeapotVertices];
extern const Normal kTeapotNormals[kTeapotVertices];
extern const Triangle kTeapotTriangles[kTeapotTriangleCount];

inline constexpr Mesh kTeapotMesh[] = {{.positions = kTeapotPositions,
                                        .normals = kTeapotNormals,
                                        .colours = {},
                                        .texcoords = {},
                                        .triangles = kTeapotTriangles,
                                        .meshlets = {},
                                        .half_extent = kTeapotHalfExtent}};
inline constexpr Material kTeapotMaterial[] = {{.colour = {235, 225, 205, 255}, .lit = true, .smooth = true}};
inline constexpr Instance kTeapotInstance[] = {{}};

inline constexpr BuiltIn teapot{.name = "teapot",
                                .description = "the Utah teapot, lit, Gouraud shaded, 992 triangles",
                                .scene = {.meshes = kTeapotMesh,
                                          .materials = kTeapotMaterial,
                                          .textures = {},
                                          .instances = kTeapotInstance,
                                          .lights = kKeyLight,
                                          .ambient = kAmbient},
                                .counts = counts_of_one(kTeapotMesh[0], kTeapotMaterial[0]),
                                .camera = turntable_camera(4.0, 20, 5.75),
                                .focal_across = fixed(3.65)};

}  // namespace zstrip::scenes
