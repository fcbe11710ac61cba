// The knot of knot.hpp cut into 64 meshlets of 10 x 4 quads. The cut duplicates the vertices along the borders, so
// here the texture closes around the tube as well: the textured variant lives on the cut mesh.
#pragma once

#include <array>

#include "zstrip_scenes/knot.hpp"

namespace zstrip::scenes {

inline constexpr std::size_t kKnotPatchRings = 10;  // quads of a patch along the tube
inline constexpr std::size_t kKnotPatchSides = 4;   // quads of a patch around the tube
inline constexpr std::size_t kKnotPatchVertices = (kKnotPatchRings + 1) * (kKnotPatchSides + 1);
inline constexpr std::size_t kKnotPatches = kKnotVertices / (kKnotPatchRings * kKnotPatchSides);
inline constexpr std::size_t kKnotMeshletsVertices = kKnotPatches * kKnotPatchVertices;
inline constexpr std::uint8_t kKnotTexcoordBits = 11;  // u runs to 8.0
inline constexpr std::uint8_t kKnotTextureLog2 = 5;

extern const std::array<Position, kKnotMeshletsVertices> kKnotMeshletsPositions;
extern const std::array<Normal, kKnotMeshletsVertices> kKnotMeshletsNormals;
extern const std::array<Colour, kKnotMeshletsVertices> kKnotMeshletsColours;
extern const std::array<TexCoord, kKnotMeshletsVertices> kKnotMeshletsTexcoords;  ///< u 0..8, v 0..1
extern const std::array<Triangle, kKnotTriangleCount> kKnotMeshletsTriangles;
extern const std::array<Meshlet, kKnotPatches> kKnotMeshletTable;
extern const std::array<std::uint16_t, 1U << (2 * kKnotTextureLog2)> kKnotTexels;

inline constexpr Mesh kKnotMeshletsMesh[] = {{.positions = kKnotMeshletsPositions,
                                              .normals = {},
                                              .colours = kKnotMeshletsColours,
                                              .texcoords = {},
                                              .triangles = kKnotMeshletsTriangles,
                                              .meshlets = kKnotMeshletTable,
                                              .centre = kKnotCentre,
                                              .half_extent = kKnotHalfExtent}};
inline constexpr Mesh kKnotTexturedMesh[] = {{.positions = kKnotMeshletsPositions,
                                              .normals = kKnotMeshletsNormals,
                                              .colours = {},
                                              .texcoords = kKnotMeshletsTexcoords,
                                              .triangles = kKnotMeshletsTriangles,
                                              .meshlets = kKnotMeshletTable,
                                              .centre = kKnotCentre,
                                              .half_extent = kKnotHalfExtent,
                                              .texcoord_bits = kKnotTexcoordBits}};
inline constexpr Material kKnotTexturedMaterial[] = {{.texture = 0, .lit = true, .smooth = true}};
inline constexpr Texture kKnotTexture[] = {{kKnotTexels, kKnotTextureLog2, kKnotTextureLog2}};

inline constexpr BuiltIn knot_meshlets{
    .name = "knot_meshlets",
    .description = "the knot of workload K5 in 64 meshlets",
    .scene = {.meshes = kKnotMeshletsMesh,
              .materials = kKnotMaterial,
              .textures = {},
              .instances = kKnotInstance,
              .lights = {}},
    .counts = counts_of_one(kKnotMeshletsMesh[0], kKnotMaterial[0], kKnotPatchVertices,
                            2 * kKnotPatchRings * kKnotPatchSides),
    .camera = knot.camera,
    .focal_across = knot.focal_across};

inline constexpr BuiltIn knot_textured{
    .name = "knot_textured",
    .description = "the knot in 64 meshlets, textured, lit, Gouraud shaded",
    .scene = {.meshes = kKnotTexturedMesh,
              .materials = kKnotTexturedMaterial,
              .textures = kKnotTexture,
              .instances = kKnotInstance,
              .lights = kKeyLight,
              .ambient = kAmbient},
    .counts = counts_of_one(kKnotTexturedMesh[0], kKnotTexturedMaterial[0], kKnotPatchVertices,
                            2 * kKnotPatchRings * kKnotPatchSides),
    .camera = knot.camera,
    .focal_across = knot.focal_across};

}  // namespace zstrip::scenes
