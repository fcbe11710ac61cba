// A globe of nine wires, each hardly a pixel thick in a small picture, so that almost every pixel is an edge.
#pragma once

#include <array>

#include "zstrip_scenes/built_in.hpp"
#include "zstrip_scenes/presentation.hpp"

namespace zstrip::scenes {

inline constexpr std::size_t kWireMeridians = 6;  // whole circles through both poles
inline constexpr std::size_t kWireParallels = 3;
inline constexpr std::size_t kWireSegments = 32;  // segments of a circle
inline constexpr std::size_t kWireSides = 3;      // sides of the prism that is a wire
inline constexpr std::size_t kWiresVertices = (kWireMeridians + kWireParallels) * kWireSegments * kWireSides;
inline constexpr double kWireRadius = 0.008;  // for a globe of radius 1

extern const std::array<Position, kWiresVertices> kWiresPositions;
extern const std::array<Normal, kWiresVertices> kWiresNormals;
extern const std::array<Triangle, 2 * kWiresVertices> kWiresTriangles;

inline constexpr Mesh kWiresMesh[] = {
    {.positions = kWiresPositions,
     .normals = kWiresNormals,
     .colours = {},
     .texcoords = {},
     .triangles = kWiresTriangles,
     .meshlets = {},
     .half_extent = {fixed(1 + kWireRadius), fixed(1 + kWireRadius), fixed(1 + kWireRadius)}}};
inline constexpr Material kWiresMaterial[] = {{.colour = {250, 205, 120, 255}, .lit = true, .smooth = true}};
inline constexpr Instance kWiresInstance[] = {{}};

inline constexpr BuiltIn wires{.name = "wires",
                               .description = "a globe of nine thin wires, lit, Gouraud shaded",
                               .scene = {.meshes = kWiresMesh,
                                         .materials = kWiresMaterial,
                                         .textures = {},
                                         .instances = kWiresInstance,
                                         .lights = kKeyLight,
                                         .ambient = kAmbient},
                               .counts = counts_of_one(kWiresMesh[0], kWiresMaterial[0]),
                               .camera = turntable_camera(4.0, 20, 3.8),
                               .focal_across = fixed(3.8)};

}  // namespace zstrip::scenes
