// Hills to the horizon, in 36 meshlets: 240 units from side to side, seen by a camera whose near plane is 0.1 units
// away. It tests the resolution of a z-buffer at large distances.
#pragma once

#include <array>

#include "zstrip_scenes/built_in.hpp"
#include "zstrip_scenes/presentation.hpp"

namespace zstrip::scenes {

inline constexpr std::size_t kTerrainTiles = 6;      // tiles a side
inline constexpr std::size_t kTerrainTileQuads = 7;  // quads a side of a tile
inline constexpr std::size_t kTerrainTileVertices = (kTerrainTileQuads + 1) * (kTerrainTileQuads + 1);
inline constexpr std::size_t kTerrainVertices = kTerrainTiles * kTerrainTiles * kTerrainTileVertices;
inline constexpr std::size_t kTerrainTileTriangles = 2 * kTerrainTileQuads * kTerrainTileQuads;
inline constexpr std::size_t kTerrainTriangleCount = kTerrainTiles * kTerrainTiles * kTerrainTileTriangles;
inline constexpr Vec3 kTerrainHalfExtent{fixed(120), fixed(9), fixed(120)};

extern const std::array<Position, kTerrainVertices> kTerrainPositions;
extern const std::array<Colour, kTerrainVertices> kTerrainColours;
extern const std::array<Triangle, kTerrainTriangleCount> kTerrainTriangles;
extern const std::array<Meshlet, kTerrainTiles * kTerrainTiles> kTerrainMeshlets;

inline constexpr Mesh kTerrainMesh[] = {{.positions = kTerrainPositions,
                                         .normals = {},
                                         .colours = kTerrainColours,
                                         .texcoords = {},
                                         .triangles = kTerrainTriangles,
                                         .meshlets = kTerrainMeshlets,
                                         .centre = {0, fixed(-8), 0},
                                         .half_extent = kTerrainHalfExtent}};
inline constexpr Material kTerrainMaterial[] = {{.lit = false, .smooth = true}};
inline constexpr Instance kTerrainInstance[] = {{}};

consteval Camera terrain_camera() {
  Camera camera = turntable_camera(24, 15, 1.6);
  camera.far_plane = fixed(300);
  return camera;
}

inline constexpr BuiltIn terrain{
    .name = "terrain",
    .description = "hills to the horizon in 36 meshlets, 3528 triangles, vertex colours",
    .scene = {.meshes = kTerrainMesh,
              .materials = kTerrainMaterial,
              .textures = {},
              .instances = kTerrainInstance,
              .lights = {},
              .background = {150, 190, 230, 255}},
    .counts = counts_of_one(kTerrainMesh[0], kTerrainMaterial[0], kTerrainTileVertices, kTerrainTileTriangles),
    .camera = terrain_camera(),
    .focal_across = fixed(7.9),
    .turns = Turns::camera};

}  // namespace zstrip::scenes
