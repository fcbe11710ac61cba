// A closed trefoil knot of 160 rings with 16 vertices each: the benchmarks' workload K5 (5120 triangles, unlit, Gouraud
// shaded vertex colours = normal / 2 + 1/2), and its flat and lit variants.
#pragma once

#include <array>

#include "zstrip_scenes/built_in.hpp"
#include "zstrip_scenes/presentation.hpp"

namespace zstrip::scenes {

inline constexpr std::size_t kKnotRings = 160;
inline constexpr std::size_t kKnotRingVertices = 16;
inline constexpr std::size_t kKnotVertices = kKnotRings * kKnotRingVertices;
inline constexpr std::size_t kKnotTriangleCount = 2 * kKnotVertices;

// The box around x +-0.896, y -0.970..0.707, z +-0.410, in 16.16.
inline constexpr Vec3 kKnotCentre{0, -8604, 0};
inline constexpr Vec3 kKnotHalfExtent{58724, 54968, 26871};

extern const std::array<Position, kKnotVertices> kKnotPositions;
extern const std::array<Normal, kKnotVertices> kKnotNormals;
extern const std::array<Colour, kKnotVertices> kKnotColours;
extern const std::array<Triangle, kKnotTriangleCount> kKnotTriangles;

inline constexpr Mesh kKnotMesh[] = {{.positions = kKnotPositions,
                                      .normals = {},
                                      .colours = kKnotColours,
                                      .texcoords = {},
                                      .triangles = kKnotTriangles,
                                      .meshlets = {},
                                      .centre = kKnotCentre,
                                      .half_extent = kKnotHalfExtent}};
inline constexpr Mesh kKnotLitMesh[] = {{.positions = kKnotPositions,
                                         .normals = kKnotNormals,
                                         .colours = {},
                                         .texcoords = {},
                                         .triangles = kKnotTriangles,
                                         .meshlets = {},
                                         .centre = kKnotCentre,
                                         .half_extent = kKnotHalfExtent}};
inline constexpr Material kKnotMaterial[] = {{.lit = false, .smooth = true}};
inline constexpr Material kKnotFlatMaterial[] = {{.lit = false, .smooth = false}};
inline constexpr Material kKnotLitMaterial[] = {{.colour = {120, 190, 255, 255}, .lit = true, .smooth = true}};
inline constexpr Instance kKnotInstance[] = {{}};

inline constexpr BuiltIn knot{
    .name = "knot",
    .description = "a trefoil knot with vertex colours, Gouraud shaded, 5120 triangles (workload K5)",
    .scene =
        {.meshes = kKnotMesh, .materials = kKnotMaterial, .textures = {}, .instances = kKnotInstance, .lights = {}},
    .counts = counts_of_one(kKnotMesh[0], kKnotMaterial[0]),
    .camera = turntable_camera(4.0, 20, 4.05),
    .focal_across = fixed(4.0)};

inline constexpr BuiltIn knot_flat{.name = "knot_flat",
                                   .description = "the knot with vertex colours, flat shaded",
                                   .scene = {.meshes = kKnotMesh,
                                             .materials = kKnotFlatMaterial,
                                             .textures = {},
                                             .instances = kKnotInstance,
                                             .lights = {}},
                                   .counts = knot.counts,
                                   .camera = knot.camera,
                                   .focal_across = knot.focal_across};

inline constexpr BuiltIn knot_lit{.name = "knot_lit",
                                  .description = "the knot in one colour, lit, Gouraud shaded",
                                  .scene = {.meshes = kKnotLitMesh,
                                            .materials = kKnotLitMaterial,
                                            .textures = {},
                                            .instances = kKnotInstance,
                                            .lights = kKeyLight,
                                            .ambient = kAmbient},
                                  .counts = counts_of_one(kKnotLitMesh[0], kKnotLitMaterial[0]),
                                  .camera = knot.camera,
                                  .focal_across = knot.focal_across};

}  // namespace zstrip::scenes
