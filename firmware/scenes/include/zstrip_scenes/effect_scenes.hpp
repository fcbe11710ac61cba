// A small scene for each effect of light or fragments, which shows only this effect. Their shapes are those of the room
// and the knot.
#pragma once

#include <span>

#include "zstrip_scenes/knot.hpp"
#include "zstrip_scenes/room.hpp"

namespace zstrip::scenes {

/// Returns a box of half sides (across, up, deep) around (x, y, z).
consteval Instance block(std::uint16_t material, double across, double up, double deep, double x, double y, double z) {
  return {.mesh = 1,
          .material = material,
          .transform = {{{fixed(across), 0, 0, fixed(x)}, {0, fixed(up), 0, fixed(y)}, {0, 0, fixed(deep), fixed(z)}}}};
}

/// Returns a scene seen from `degrees` above the horizon.
consteval BuiltIn effect_scene(const char* name, const char* description, const Scene& scene, const SceneCounts& counts,
                               double distance, double degrees, double focal) {
  return {.name = name,
          .description = description,
          .scene = scene,
          .counts = counts,
          .camera = turntable_camera(distance, degrees, focal),
          .focal_across = fixed(focal)};
}

// Light needs a uniform scale: flattened boxes are unlit.
inline constexpr Material kFogMaterials[] = {{.texture = 1, .lit = false},
                                             {.colour = {225, 105, 70, 255}, .lit = true, .smooth = false},
                                             {.colour = {80, 150, 220, 255}, .lit = true, .smooth = false}};
inline constexpr Instance kFogInstances[] = {
    block(0, 1.6, 0.005, 4.4, 0, -0.905, -2.2), block(1, 0.45, 0.45, 0.45, -0.8, -0.45, 0.4),
    block(2, 0.45, 0.45, 0.45, 0.8, -0.45, -1.8), block(1, 0.45, 0.45, 0.45, -0.8, -0.45, -4.2)};
inline constexpr Fog kFog{.colour = {150, 165, 180, 255}, .mode = FogMode::exponential_squared, .density = fixed(0.16)};
inline constexpr Scene kFogScene{.meshes = kRoomMeshes,
                                 .materials = kFogMaterials,
                                 .textures = kRoomTextures,
                                 .instances = kFogInstances,
                                 .lights = kRoomLights,
                                 .ambient = {70, 70, 70, 255},
                                 .background = {150, 165, 180, 255},
                                 .fog = &kFog};
inline constexpr BuiltIn fog =
    effect_scene("fog", "boxes on a floor that fade with their distance", kFogScene, count(kFogScene), 3.2, 10, 1.7);

inline constexpr Finish kGlowingFinish[] = {{.emissive = {200, 90, 20, 255}}};
inline constexpr Material kGlowingMaterials[] = {
    {.colour = {90, 80, 75, 255}, .lit = true, .smooth = true},
    {.colour = {90, 80, 75, 255}, .lit = true, .smooth = true, .finish = 0}};
inline constexpr DirectionalLight kDimLight[] = {light_from(-0.5, 0.7, 0.6, {120, 120, 130, 255})};
inline constexpr Instance kPairInstances[] = {
    {.material = 0, .transform = {{{kFixedOne, 0, 0, fixed(-0.75)}, {0, kFixedOne, 0, 0}, {0, 0, kFixedOne, 0}}}},
    {.material = 1, .transform = {{{kFixedOne, 0, 0, fixed(0.75)}, {0, kFixedOne, 0, 0}, {0, 0, kFixedOne, 0}}}}};

/// Returns two knots side by side; the right one has the effect.
consteval BuiltIn pair_of_knots(const char* name, const char* description, const Scene& scene) {
  return effect_scene(name, description, scene,
                      {.instances = 2,
                       .triangles = 2 * kKnotTriangleCount,
                       .vertices = 2 * kKnotVertices,
                       .largest_meshlet = kKnotVertices,
                       .meshlets = 2,
                       .longest_meshlet = kKnotTriangleCount},
                      4.0, 20, 2.0);
}

inline constexpr Scene kEmissiveScene{.meshes = kKnotLitMesh,
                                      .materials = kGlowingMaterials,
                                      .textures = {},
                                      .instances = kPairInstances,
                                      .lights = kDimLight,
                                      .ambient = {30, 30, 30, 255},
                                      .finishes = kGlowingFinish};
inline constexpr BuiltIn emissive =
    pair_of_knots("emissive", "two knots in dim light, of which the right one glows", kEmissiveScene);

inline constexpr Finish kPolishedFinish[] = {{.specular = {255, 255, 255, 255}, .shininess = 40}};
inline constexpr Material kPolishedMaterials[] = {
    {.colour = {150, 60, 50, 255}, .lit = true, .smooth = true},
    {.colour = {150, 60, 50, 255}, .lit = true, .smooth = true, .finish = 0}};
inline constexpr Scene kSpecularScene{.meshes = kKnotLitMesh,
                                      .materials = kPolishedMaterials,
                                      .textures = {},
                                      .instances = kPairInstances,
                                      .lights = kKeyLight,
                                      .ambient = kAmbient,
                                      .finishes = kPolishedFinish};
inline constexpr BuiltIn specular =
    pair_of_knots("specular", "two knots, of which the right one is polished", kSpecularScene);

/// A red point light between the knots, and a spot from above on the right one.
inline constexpr PunctualLight kPunctualLights[] = {
    {.colour = {255, 70, 50, 255}, .position = {0, fixed(0.2), fixed(0.6)}, .intensity = fixed(0.6), .range = fixed(3)},
    {.type = PunctualLightType::spot,
     .colour = {120, 160, 255, 255},
     .position = {fixed(0.75), fixed(2), fixed(0.8)},
     .intensity = fixed(6),
     .x = 0,
     .y = -30426,
     .z = -12163,
     .cosine_inner = 32000,
     .cosine_outer = 31000}};
inline constexpr Material kChalk[] = {{.colour = {220, 220, 220, 255}, .lit = true, .smooth = true},
                                      {.colour = {220, 220, 220, 255}, .lit = true, .smooth = true}};
inline constexpr Scene kPunctualScene{.meshes = kKnotLitMesh,
                                      .materials = kChalk,
                                      .textures = {},
                                      .instances = kPairInstances,
                                      .lights = {},
                                      .ambient = {20, 20, 26, 255},
                                      .punctual_lights = kPunctualLights};
inline constexpr BuiltIn punctual =
    pair_of_knots("punctual", "two knots lit by a point light between them and a spot from above", kPunctualScene);

/// Bars with holes between them, 16 x 16, and the alpha behind them.
extern const std::array<std::uint16_t, 256 + 128> kLatticeTexels;
inline constexpr Texture kLatticeTextures[] = {{kLatticeTexels, 4, 4, TextureFormat::rgb565_alpha},
                                               {kCubeTexels, kCubeTextureLog2, kCubeTextureLog2}};
inline constexpr Finish kMaskFinish[] = {{.alpha_mode = AlphaMode::mask}};
inline constexpr Material kMaskMaterials[] = {
    {.texture = 0, .lit = false, .smooth = false, .double_sided = true, .finish = 0},
    {.texture = 1, .lit = false, .smooth = false}};
inline constexpr Instance kMaskInstances[] = {block(0, 0.9, 0.9, 0.9, 0, 0, 0), block(1, 0.4, 0.4, 0.4, 0, 0, 0)};
inline constexpr Scene kMaskScene{.meshes = kRoomMeshes,
                                  .materials = kMaskMaterials,
                                  .textures = kLatticeTextures,
                                  .instances = kMaskInstances,
                                  .lights = {},
                                  .background = {40, 50, 60, 255},
                                  .finishes = kMaskFinish};
inline constexpr BuiltIn mask =
    effect_scene("mask", "a box in a lattice with holes", kMaskScene, count(kMaskScene), 4.0, 20, 2.2);

inline constexpr Finish kGlassFinish[] = {{.alpha_mode = AlphaMode::blend}};
inline constexpr Material kGlassMaterials[] = {
    {.colour = {230, 60, 50, 110}, .lit = true, .smooth = false, .finish = 0},
    {.colour = {60, 200, 90, 110}, .lit = true, .smooth = false, .finish = 0},
    {.colour = {70, 90, 240, 110}, .lit = true, .smooth = false, .finish = 0},
    {.texture = 1, .lit = false, .smooth = false}};
/// Drawn in this order they are wrong from every side: the opaque one is last.
inline constexpr Instance kGlassInstances[] = {
    block(0, 0.7, 0.7, 0.1, 0.25, 0.1, 0.7), block(1, 0.7, 0.7, 0.1, -0.2, 0, 0.25),
    block(2, 0.7, 0.7, 0.1, 0.1, -0.1, -0.6), block(3, 0.3, 0.3, 0.3, 0, 0, -0.1)};
inline constexpr Scene kBlendScene{.meshes = kRoomMeshes,
                                   .materials = kGlassMaterials,
                                   .textures = kLatticeTextures,
                                   .instances = kGlassInstances,
                                   .lights = kRoomLights,
                                   .ambient = {70, 70, 70, 255},
                                   .background = {235, 235, 235, 255},
                                   .finishes = kGlassFinish};
inline constexpr BuiltIn blend =
    effect_scene("blend", "three panes of glass and a box between them", kBlendScene, count(kBlendScene), 4.0, 20, 2.6);

inline constexpr Finish kSmoothTexels[] = {{.filter = TextureFilter::bilinear}};
inline constexpr Texture kCoarseTextures[] = {{kRoomTexels, kRoomTextureLog2, kRoomTextureLog2}};
inline constexpr Material kBilinearMaterials[] = {{.texture = 0, .lit = false, .smooth = false},
                                                  {.texture = 0, .lit = false, .smooth = false, .finish = 0}};
inline constexpr Instance kBilinearInstances[] = {block(0, 0.6, 0.6, 0.6, -0.75, 0, 0),
                                                  block(1, 0.6, 0.6, 0.6, 0.75, 0, 0)};
inline constexpr Scene kBilinearScene{.meshes = kRoomMeshes,
                                      .materials = kBilinearMaterials,
                                      .textures = kCoarseTextures,
                                      .instances = kBilinearInstances,
                                      .lights = {},
                                      .finishes = kSmoothTexels};
inline constexpr BuiltIn bilinear =
    effect_scene("bilinear", "two boxes with coarse texels, those of the right one filtered", kBilinearScene,
                 count(kBilinearScene), 4.0, 20, 2.0);

/// The tiles of the room's texture as indices.
extern const std::array<std::uint16_t, 16 + 64> kIndexedTexels;
inline constexpr Texture kTileTextures[] = {
    {kRoomTexels, kRoomTextureLog2, kRoomTextureLog2},
    {kIndexedTexels, kRoomTextureLog2, kRoomTextureLog2, TextureFormat::palette4}};
inline constexpr Finish kPlainFinish[] = {{}};
inline constexpr Material kPaletteMaterials[] = {{.texture = 0, .lit = true, .smooth = false},
                                                 {.texture = 1, .lit = true, .smooth = false, .finish = 0}};
inline constexpr Scene kPaletteScene{.meshes = kRoomMeshes,
                                     .materials = kPaletteMaterials,
                                     .textures = kTileTextures,
                                     .instances = kBilinearInstances,
                                     .lights = kRoomLights,
                                     .ambient = {70, 70, 70, 255},
                                     .finishes = kPlainFinish};
inline constexpr BuiltIn palette =
    effect_scene("palette", "two boxes with the same texels, those of the right one indices of 4 bits", kPaletteScene,
                 count(kPaletteScene), 4.0, 20, 2.0);

/// Squares of 8x8 texels, followed by four pictures of half the size each, down to one texel.
extern const std::array<std::uint16_t, 256 + 64 + 16 + 4 + 1> kChequerTexels;
inline constexpr Texture kChequerTextures[] = {{.texels = kChequerTexels,
                                                .log2_width = 4,
                                                .log2_height = 4,
                                                .format = TextureFormat::rgb565,
                                                .smaller_levels = 4}};
/// A strip of floor, 2 x 12, on which the texture repeats 4 times across and 24 times along.
extern const std::array<Position, 4> kFloorPositions;
extern const std::array<TexCoord, 4> kFloorTexcoords;
extern const std::array<Triangle, 2> kFloorTriangles;
inline constexpr Mesh kFloorMesh[] = {{.positions = kFloorPositions,
                                       .normals = {},
                                       .colours = {},
                                       .texcoords = kFloorTexcoords,
                                       .triangles = kFloorTriangles,
                                       .meshlets = {},
                                       .half_extent = {fixed(1), 0, fixed(6)},
                                       .texcoord_bits = 10}};
inline constexpr Material kMipmapMaterials[] = {{.texture = 0, .lit = false, .smooth = false},
                                                {.texture = 0, .lit = false, .smooth = false, .finish = 0}};
consteval Instance floor_at(std::uint16_t material, double x, double z) {
  Instance instance{.material = material};
  instance.transform.m[0][3] = fixed(x);
  instance.transform.m[2][3] = fixed(z);
  return instance;
}
inline constexpr Instance kMipmapInstances[] = {floor_at(0, -1.02, -4), floor_at(1, 1.02, -4)};
inline constexpr Scene kMipmapScene{.meshes = kFloorMesh,
                                    .materials = kMipmapMaterials,
                                    .textures = kChequerTextures,
                                    .instances = kMipmapInstances,
                                    .lights = {},
                                    .background = {120, 150, 180, 255},
                                    .finishes = kPlainFinish};
inline constexpr BuiltIn mipmaps =
    effect_scene("mipmaps", "a chequered floor towards the horizon, its right half with mipmaps", kMipmapScene,
                 count(kMipmapScene), 3.0, 12, 2.0);

/// A mirrored ball, 32 x 32: sky, a window in it, and a floor.
extern const std::array<std::uint16_t, 1024> kEnvironmentTexels;
inline constexpr Texture kEnvironmentMap[] = {{kEnvironmentTexels, 5, 5}};
inline constexpr Finish kChromeFinish[] = {{.filter = TextureFilter::environment_nearest}};
inline constexpr Material kChromeMaterials[] = {{.colour = {190, 192, 196, 255}, .lit = true, .smooth = true},
                                                {.texture = 0, .lit = false, .smooth = true, .finish = 0}};
inline constexpr Scene kEnvironmentScene{.meshes = kKnotLitMesh,
                                         .materials = kChromeMaterials,
                                         .textures = kEnvironmentMap,
                                         .instances = kPairInstances,
                                         .lights = kKeyLight,
                                         .ambient = kAmbient,
                                         .finishes = kChromeFinish};
inline constexpr BuiltIn environment =
    pair_of_knots("environment", "two knots, of which the right one has an environment map", kEnvironmentScene);

/// A ball of few triangles: an octahedron whose edges are cut in four and whose corners are moved to a sphere.
inline constexpr std::size_t kBallVertices = 66, kBallTriangleCount = 128;
extern const std::array<Position, kBallVertices> kBallPositions;
extern const std::array<Normal, kBallVertices> kBallNormals;
extern const std::array<Triangle, kBallTriangleCount> kBallTriangles;
inline constexpr Mesh kBallMesh[] = {{.positions = kBallPositions,
                                      .normals = kBallNormals,
                                      .colours = {},
                                      .texcoords = {},
                                      .triangles = kBallTriangles,
                                      .meshlets = {}}};
inline constexpr Material kLacqueredMaterials[] = {
    {.colour = {150, 60, 50, 255}, .lit = true, .smooth = true, .finish = 0},
    {.colour = {150, 60, 50, 255}, .lit = true, .smooth = Shading::pixel, .finish = 0}};
/// Returns a ball with a radius of more than half a unit, `x` to the right.
consteval Instance ball(std::uint16_t material, double x) {
  return {.material = material,
          .transform = {{{fixed(0.65), 0, 0, fixed(x)}, {0, fixed(0.65), 0, 0}, {0, 0, fixed(0.65), 0}}}};
}
inline constexpr Instance kBallInstances[] = {ball(0, -0.75), ball(1, 0.75)};
inline constexpr Scene kPerPixelScene{.meshes = kBallMesh,
                                      .materials = kLacqueredMaterials,
                                      .textures = {},
                                      .instances = kBallInstances,
                                      .lights = kKeyLight,
                                      .ambient = kAmbient,
                                      .finishes = kPolishedFinish};
inline constexpr BuiltIn per_pixel =
    effect_scene("per_pixel", "two polished balls of few triangles, of which the right one is lit at its pixels",
                 kPerPixelScene, count(kPerPixelScene), 4.0, 20, 2.0);

/// Returns all scenes of this file, in its order.
std::span<const BuiltIn> effect_scenes();

}  // namespace zstrip::scenes
