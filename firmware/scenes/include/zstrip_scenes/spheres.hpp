// Spheres and ellipsoids on a floor: one is cut by a cube, one has a texture, one has three different axes. The cube
// and its texture are those of cube.hpp.
#pragma once

#include <array>

#include "zstrip_scenes/cube.hpp"

namespace zstrip::scenes {

inline constexpr std::uint8_t kGlobeTextureLog2[2] = {5, 4};

extern const std::array<std::uint16_t, 1U << (kGlobeTextureLog2[0] + kGlobeTextureLog2[1])> kGlobeTexels;

inline constexpr Mesh kSpheresMeshes[] = {kLitCube};
inline constexpr Texture kSpheresTextures[] = {{kGlobeTexels, kGlobeTextureLog2[0], kGlobeTextureLog2[1]}};
inline constexpr Material kSpheresMaterials[] = {{.colour = {96, 104, 112, 255}, .lit = false, .smooth = false},
                                                 {.colour = {240, 200, 90, 255}, .smooth = false},
                                                 {.colour = {225, 85, 60, 255}},
                                                 {.texture = 0},
                                                 {.colour = {90, 170, 120, 255}}};
inline constexpr Instance kSpheresInstances[] = {
    {.material = 0, .transform = {{{fixed(2.2), 0, 0, 0}, {0, fixed(0.05), 0, fixed(-1.05)}, {0, 0, fixed(1.6), 0}}}},
    {.material = 1,
     .transform = {{{fixed(0.45), 0, fixed(0.35), fixed(-0.75)},
                    {0, fixed(0.55), 0, fixed(-0.45)},
                    {fixed(-0.35), 0, fixed(0.45), fixed(0.25)}}}}};
/// The ellipsoid is rotated by 30 degrees about z.
inline constexpr Quadric kSpheresQuadrics[] = {
    {.material = 2,
     .transform = {{{fixed(0.75), 0, 0, fixed(-1.1)}, {0, fixed(0.75), 0, fixed(-0.25)}, {0, 0, fixed(0.75), 0}}}},
    {.material = 3,
     .transform = {{{fixed(0.6), 0, 0, fixed(0.35)}, {0, fixed(0.6), 0, fixed(-0.4)}, {0, 0, fixed(0.6), fixed(0.6)}}}},
    {.material = 4,
     .transform = {{{fixed(0.606), fixed(-0.15), 0, fixed(1.2)},
                    {fixed(0.35), fixed(0.26), 0, fixed(-0.5)},
                    {0, 0, fixed(0.45), fixed(-0.5)}}}}};
inline constexpr Scene kSpheresScene{.meshes = kSpheresMeshes,
                                     .materials = kSpheresMaterials,
                                     .textures = kSpheresTextures,
                                     .instances = kSpheresInstances,
                                     .lights = kKeyLight,
                                     .ambient = kAmbient,
                                     .background = {24, 32, 48, 255},
                                     .quadrics = kSpheresQuadrics};

inline constexpr BuiltIn spheres{.name = "spheres",
                                 .description = "spheres and an ellipsoid, pixel by pixel, cut by a cube on a floor",
                                 .scene = kSpheresScene,
                                 .counts = count(kSpheresScene),
                                 .camera = turntable_camera(5.5, 15, 2.4),
                                 .focal_across = fixed(1.9),
                                 .turns = Turns::camera};

}  // namespace zstrip::scenes
