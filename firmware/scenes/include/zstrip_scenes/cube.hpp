// A cube of side 2, with separate vertices for each face, textured 64 x 64: the benchmarks' workload CT.
#pragma once

#include <array>

#include "zstrip_scenes/built_in.hpp"
#include "zstrip_scenes/presentation.hpp"

namespace zstrip::scenes {

inline constexpr std::uint8_t kCubeTextureLog2 = 6;
inline constexpr Vec3 kCubeHalfExtent{65538, 65538, 65538};  // 16.16: 1.0 at grid 32767

extern const std::array<Position, 24> kCubePositions;
extern const std::array<Normal, 24> kCubeNormals;
extern const std::array<TexCoord, 24> kCubeTexcoords;
extern const std::array<Triangle, 12> kCubeTriangles;
extern const std::array<std::uint16_t, 1U << (2 * kCubeTextureLog2)> kCubeTexels;

/// The cube for scenes with light; the workload has no normals.
inline constexpr Mesh kLitCube{.positions = kCubePositions,
                               .normals = kCubeNormals,
                               .colours = {},
                               .texcoords = kCubeTexcoords,
                               .triangles = kCubeTriangles,
                               .meshlets = {},
                               .half_extent = kCubeHalfExtent};
inline constexpr Mesh kCubeMesh[] = {{.positions = kCubePositions,
                                      .normals = {},
                                      .colours = {},
                                      .texcoords = kCubeTexcoords,
                                      .triangles = kCubeTriangles,
                                      .meshlets = {},
                                      .half_extent = kCubeHalfExtent}};
inline constexpr Material kCubeMaterial[] = {{.texture = 0, .lit = false, .smooth = false}};
inline constexpr Texture kCubeTexture[] = {{kCubeTexels, kCubeTextureLog2, kCubeTextureLog2}};
inline constexpr Instance kCubeInstance[] = {{}};

inline constexpr BuiltIn cube{.name = "cube",
                              .description = "a textured cube, 12 triangles (workload CT)",
                              .scene = {.meshes = kCubeMesh,
                                        .materials = kCubeMaterial,
                                        .textures = kCubeTexture,
                                        .instances = kCubeInstance,
                                        .lights = {}},
                              .counts = counts_of_one(kCubeMesh[0], kCubeMaterial[0]),
                              .camera = turntable_camera(5.0, 20, 2.7),
                              .focal_across = fixed(3.0),
                              .workload_distance = fixed(2.2)};

}  // namespace zstrip::scenes
