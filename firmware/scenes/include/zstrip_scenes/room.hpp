// A room of 4 x 2.5 x 4 units seen from inside, with three boxes on its floor: large textured and lit polygons that
// reach behind the camera. The boxes are the cube of cube.hpp.
#pragma once

#include <array>

#include "zstrip_scenes/cube.hpp"

namespace zstrip::scenes {

inline constexpr std::uint8_t kRoomTextureLog2 = 4;

extern const std::array<Position, 24> kRoomPositions;
extern const std::array<Normal, 24> kRoomNormals;
extern const std::array<TexCoord, 24> kRoomTexcoords;
extern const std::array<Triangle, 12> kRoomTriangles;
extern const std::array<std::uint16_t, 1U << (2 * kRoomTextureLog2)> kRoomTexels;

inline constexpr Mesh kRoomMeshes[] = {{.positions = kRoomPositions,
                                        .normals = kRoomNormals,
                                        .colours = {},
                                        .texcoords = kRoomTexcoords,
                                        .triangles = kRoomTriangles,
                                        .meshlets = {},
                                        .half_extent = {fixed(2.0), fixed(1.25), fixed(2.0)}},
                                       kLitCube};
inline constexpr Texture kRoomTextures[] = {{kRoomTexels, kRoomTextureLog2, kRoomTextureLog2},
                                            {kCubeTexels, kCubeTextureLog2, kCubeTextureLog2}};
inline constexpr Material kRoomMaterials[] = {{.texture = 0, .lit = true, .smooth = false},
                                              {.texture = 1, .lit = true, .smooth = false},
                                              {.colour = {225, 105, 70, 255}, .lit = true, .smooth = false},
                                              {.colour = {80, 150, 220, 255}, .lit = true, .smooth = false}};

/// Returns a cube of half side `size` that stands on the floor at (x, z), rotated by `degrees`.
consteval Instance box(std::uint16_t material, double size, double x, double z, double degrees) {
  const double angle = degrees * compile_time::kPi / 180;
  const Fixed cosine = fixed(size * compile_time::cosine(angle)), sine = fixed(size * compile_time::sine(angle));
  return {.mesh = 1,
          .material = material,
          .transform = {
              {{cosine, 0, sine, fixed(x)}, {0, fixed(size), 0, fixed(size - 1.25)}, {-sine, 0, cosine, fixed(z)}}}};
}
inline constexpr Instance kRoomInstances[] = {
    {.mesh = 0, .material = 0}, box(1, 0.45, -0.35, -0.3, 20), box(2, 0.3, 0.7, 0.0, 50), box(3, 0.2, -1.05, 0.2, -15)};
/// The light comes from above, a little from the corner, so that every wall and the floor have a different brightness.
inline constexpr DirectionalLight kRoomLights[] = {light_from(0.35, 0.8, 0.55, {150, 150, 150, 255}),
                                                   light_from(-0.6, 0.3, -0.4, {70, 75, 90, 255})};

inline constexpr Scene kRoomScene{.meshes = kRoomMeshes,
                                  .materials = kRoomMaterials,
                                  .textures = kRoomTextures,
                                  .instances = kRoomInstances,
                                  .lights = kRoomLights,
                                  .ambient = {70, 70, 70, 255}};

inline constexpr BuiltIn room{.name = "room",
                              .description = "a textured, lit room with three boxes, seen from inside",
                              .scene = kRoomScene,
                              .counts = count(kRoomScene),
                              .camera = turntable_camera(1.7, 15, 1.2),
                              .focal_across = fixed(7.9),
                              .turns = Turns::camera};

}  // namespace zstrip::scenes
