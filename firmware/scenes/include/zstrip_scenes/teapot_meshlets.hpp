// The Utah teapot of teapot.hpp cut into meshlets of at most 64 vertices: the same picture with less memory.
#pragma once

#include "zstrip_scenes/teapot.hpp"

namespace zstrip::scenes {

inline constexpr std::size_t kTeapotMeshletsVertices = 686;
inline constexpr std::size_t kTeapotMeshletCount = 15;

extern const Position kTeapotMeshletsPositions[kTeapotMeshletsVertices];
extern const Normal kTeapotMeshletsNormals[kTeapotMeshletsVertices];
extern const Triangle kTeapotMeshletsTriangles[kTeapotTriangleCount];
extern const Meshlet kTeapotMeshletTable[kTeapotMeshletCount];

inline constexpr Mesh kTeapotMeshletsMesh[] = {{.positions = kTeapotMeshletsPositions,
                                                .normals = kTeapotMeshletsNormals,
                                                .colours = {},
                                                .texcoords = {},
                                                .triangles = kTeapotMeshletsTriangles,
                                                .meshlets = kTeapotMeshletTable,
                                                .half_extent = kTeapotHalfExtent}};

inline constexpr BuiltIn teapot_meshlets{.name = "teapot_meshlets",
                                         .description = "the Utah teapot in 15 meshlets",
                                         .scene = {.meshes = kTeapotMeshletsMesh,
                                                   .materials = kTeapotMaterial,
                                                   .textures = {},
                                                   .instances = kTeapotInstance,
                                                   .lights = kKeyLight,
                                                   .ambient = kAmbient},
                                         .counts = counts_of_one(kTeapotMeshletsMesh[0], kTeapotMaterial[0], 64, 112),
                                         .camera = teapot.camera,
                                         .focal_across = teapot.focal_across};

}  // namespace zstrip::scenes
