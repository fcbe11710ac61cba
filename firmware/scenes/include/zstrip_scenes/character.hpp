// A figure that walks: textured, lit, moved by a skeleton of 19 joints. The benchmarks' workload of the same name.
#pragma once

#include <array>
#include <cstdint>

#include "zstrip/skin.hpp"
#include "zstrip_scenes/built_in.hpp"
#include "zstrip_scenes/presentation.hpp"

namespace zstrip::scenes {

inline constexpr std::size_t kCharacterVertices = 3294;
inline constexpr std::size_t kCharacterTriangleCount = 4672;
inline constexpr std::size_t kCharacterMeshletCount = 56;
inline constexpr std::size_t kCharacterPatchSides = 8, kCharacterMaxPatchRings = 6;
inline constexpr std::size_t kCharacterMeshletVertices = (kCharacterPatchSides + 1) * (kCharacterMaxPatchRings + 1);
inline constexpr std::size_t kCharacterMeshletTriangles = 2 * kCharacterPatchSides * kCharacterMaxPatchRings;
inline constexpr std::size_t kCharacterJoints = 19;
inline constexpr std::size_t kCharacterKeys = 9;         // keyframes of a joint
inline constexpr std::uint32_t kCharacterStride = 1000;  // milliseconds, two steps
inline constexpr std::uint32_t kCharacterFrameTime = 40;
inline constexpr Fixed kCharacterHalfExtent = fixed(1.0);
inline constexpr std::uint8_t kCharacterTexcoordBits = 12;
inline constexpr std::uint8_t kCharacterTextureLog2 = 6;
inline constexpr std::size_t kCharacterTexelCount = 1U << (2 * kCharacterTextureLog2);

extern const std::array<Position, kCharacterVertices> kCharacterPositions;
extern const std::array<Normal, kCharacterVertices> kCharacterNormals;
extern const std::array<TexCoord, kCharacterVertices> kCharacterTexcoords;
extern const std::array<VertexJoints, kCharacterVertices> kCharacterVertexJoints;
extern const std::array<Triangle, kCharacterTriangleCount> kCharacterTriangles;
extern const std::array<Meshlet, kCharacterMeshletCount> kCharacterMeshlets;
extern const std::array<Joint, kCharacterJoints> kCharacterJointTable;
extern const std::array<JointPose, kCharacterJoints> kCharacterRest;
extern const std::array<Track, kCharacterJoints> kCharacterTracks;
extern const std::array<Keyframe, kCharacterJoints * kCharacterKeys> kCharacterKeyframes;
extern const std::array<std::uint16_t, kCharacterTexelCount> kCharacterTexels;

/// The mesh as it was modelled.
inline constexpr Mesh kCharacterBindMesh[] = {
    {.positions = kCharacterPositions,
     .normals = kCharacterNormals,
     .colours = {},
     .texcoords = kCharacterTexcoords,
     .triangles = kCharacterTriangles,
     .meshlets = kCharacterMeshlets,
     .half_extent = {kCharacterHalfExtent, kCharacterHalfExtent, kCharacterHalfExtent},
     .texcoord_bits = kCharacterTexcoordBits}};
inline constexpr Skin kCharacterSkin{.mesh = &kCharacterBindMesh[0],
                                     .vertices = kCharacterVertexJoints,
                                     .joints = kCharacterJointTable,
                                     .rest = kCharacterRest};
inline constexpr Animation kCharacterWalk{
    .tracks = kCharacterTracks, .keyframes = kCharacterKeyframes, .duration = kCharacterStride};

/// The moving data, in RAM: the joints, and the vertices of one meshlet at a time.
struct CharacterInRam {
  std::array<JointPose, kCharacterJoints> joints;
  std::array<Transform, kCharacterJoints> matrices;
  std::array<Position, kCharacterMeshletVertices> positions;
  std::array<Normal, kCharacterMeshletVertices> normals;
};
extern CharacterInRam character_in_ram;
extern Skinning character_skinning;
/// Poses the figure for a frame, 25 frames a second.
Status pose_character(std::uint32_t frame);

inline constexpr Mesh kCharacterMesh[] = {[] {
  Mesh mesh = kCharacterBindMesh[0];
  mesh.skinning = &character_skinning;
  return mesh;
}()};
inline constexpr Material kCharacterMaterial[] = {{.texture = 0, .lit = true, .smooth = true}};
inline constexpr Texture kCharacterTexture[] = {{kCharacterTexels, kCharacterTextureLog2, kCharacterTextureLog2}};
/// Rotated to show the figure half from the side.
inline constexpr Instance kCharacterInstance[] = {
    {.transform = {{{fixed(0.8), 0, fixed(0.6), 0}, {0, kFixedOne, 0, fixed(0.02)}, {fixed(-0.6), 0, fixed(0.8), 0}}}}};

inline constexpr BuiltIn character{
    .name = "character",
    .description = "a figure with a skeleton, textured, lit, Gouraud shaded, 4672 triangles",
    .scene = {.meshes = kCharacterMesh,
              .materials = kCharacterMaterial,
              .textures = kCharacterTexture,
              .instances = kCharacterInstance,
              .lights = kKeyLight,
              .ambient = kAmbient,
              .background = {24, 32, 48, 255}},
    .counts = counts_of_one(kCharacterBindMesh[0], kCharacterMaterial[0], kCharacterMeshletVertices,
                            kCharacterMeshletTriangles),
    .camera = turntable_camera(4.0, 10, 4.05),
    .focal_across = fixed(5.45),
    .pose = pose_character,
    .pose_bytes = sizeof(CharacterInRam) + sizeof(Skinning)};

}  // namespace zstrip::scenes
