// A scene that has everything that a blob can hold, as a blob; and blobs in memory, read, written over and mended.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bake/scene_blob.hpp"
#include "zstrip/blob.hpp"

namespace zstrip::sim::test {

using Bytes = std::vector<std::uint8_t>;

/// On the heap and of exactly this size, so that AddressSanitizer guards both ends.
struct Exact {
  std::unique_ptr<std::byte[]> bytes;
  std::size_t size;
  explicit Exact(std::size_t s) : bytes(new std::byte[s]()), size(s) {}
  explicit Exact(const Bytes& from) : Exact(from.size()) {
    if (!from.empty()) std::memcpy(bytes.get(), from.data(), from.size());
  }
  std::span<std::byte> span() { return {bytes.get(), size}; }
};

void put_word(Bytes& bytes, std::size_t at, std::uint32_t value);
std::uint32_t word(const Bytes& bytes, std::size_t at);
/// Makes size and checksum right again.
void mend(Bytes& bytes);

/// Where the table of sections names this one, where it begins, and how many bytes it has; 0 if there is none.
std::uint32_t entry_of(const Bytes& bytes, std::string_view tag);
std::uint32_t section(const Bytes& bytes, std::string_view tag);
std::uint32_t section_bytes(const Bytes& bytes, std::string_view tag);

/// A section by itself, and a blob of such, in this order, whatever they are.
struct Piece {
  std::string tag;
  Bytes content;
};
std::vector<Piece> pieces_of(const Bytes& bytes);
Bytes blob_of(const std::vector<Piece>& pieces);

// Two quads with everything that a mesh can have, two textures, two materials, three instances, two lights.
inline constexpr Position kPositions[] = {
    {-32767, -30000, 5}, {32767, -30000, -5}, {32767, 30000, 7}, {-32767, 30000, -32767}};
inline constexpr Normal kNormals[] = {{0, 0, 127, 0}, {0, 127, 0, 1}, {-128, 0, 0, 2}, {1, 2, 3, 4}};
inline constexpr Colour kColours[] = {{255, 0, 0, 255}, {0, 255, 0, 255}, {0, 0, 255, 254}, {9, 8, 7, 6}};
inline constexpr TexCoord kTexcoords[] = {{0, 0}, {4096, 0}, {4096, -4096}, {0, 4096}};
inline constexpr Triangle kTriangles[] = {{0, 1, 2}, {0, 2, 3}};
inline constexpr Meshlet kMeshlets[] = {{0, 0, 4, 1, 40000, {1, -2, 3}}, {1, 0, 4, 1, 65535, {-4, 5, -6}}};
inline constexpr std::uint16_t kTexels[] = {0xF800, 0x07E0, 0x001F, 0xFFFF};
inline constexpr Mesh kMeshes[] = {
    {kPositions, kNormals, kColours, kTexcoords, kTriangles, kMeshlets, {100, -200, 300}, {65536, 70000, 1}, 12},
    {kPositions, {}, {}, {}, kTriangles, {}, {0, 0, 0}, {65536, 65536, 65536}, 4}};
inline constexpr std::uint16_t kTexelsWithAlpha[] = {0xF800, 0x07E0, 0x001F, 0xFFFF, 0x8000, 0xFF40};
inline constexpr Texture kTextures[] = {{kTexelsWithAlpha, 1, 1, TextureFormat::rgb565_alpha}, {kTexels, 2, 0}};
inline constexpr Material kMaterials[] = {{.colour = {1, 2, 3, 4}, .texture = 1},
                                          {.colour = {200, 100, 50, 255},
                                           .lit = false,
                                           .smooth = false,
                                           .double_sided = true,
                                           .depth_test = DepthTest::nearer_or_equal,
                                           .depth_write = false,
                                           .finish = 1,
                                           .depth_bias = -3,
                                           .depth_slope_bias = 70000,
                                           .depth_bias_clamp = 9}};
inline constexpr Instance kInstances[] = {{0, 0, Transform::identity()},
                                          {1, 1, {{{1, -2, 3, -4}, {5, 6, 7, 8}, {9, 10, 11, -70000}}}},
                                          {0, 1, {{{30000, 0, 0, 50000}, {0, 30000, 0, 0}, {0, 0, 30000, 0}}}}};
inline constexpr DirectionalLight kLights[] = {{1, -2, 32767, {10, 20, 30, 40}}, {-32767, 0, 0, {50, 60, 70, 80}}};

inline constexpr Finish kFinishes[] = {{},
                                       {.emissive = {1, 2, 3, 4},
                                        .specular = {5, 6, 7, 8},
                                        .shininess = 9,
                                        .alpha_mode = AlphaMode::mask,
                                        .alpha_cutoff = 10,
                                        .filter = TextureFilter::bilinear}};
inline constexpr PunctualLight kPunctualLights[] = {{.colour = {9, 8, 7, 6}, .position = {1, -2, 3}},
                                                    {.type = PunctualLightType::spot,
                                                     .intensity = 70000,
                                                     .range = 80000,
                                                     .x = 1,
                                                     .y = -2,
                                                     .z = 3,
                                                     .cosine_inner = 30000,
                                                     .cosine_outer = 20000}};
inline constexpr Fog kFog{
    .colour = {4, 3, 2, 1}, .mode = FogMode::exponential, .start = 5, .end = 600000, .density = 7000};

// A palette of 16 colours for 4 texels, one of 256 for as many and one of half the size, and a word that nobody needs:
// no byte behind it.
inline constexpr auto kFourBits = [] {
  std::array<std::uint16_t, 17> words{0xF800, 0x07E0, 0x001F};
  words[16] = 0xF210;
  return words;
}();
inline constexpr std::array<std::uint16_t, 260> kEightBits{0x1111, 0x2222};
inline constexpr Texture kWithPalettes[] = {{kFourBits, 1, 1, TextureFormat::palette4},
                                            {kEightBits, 1, 1, TextureFormat::palette8, 1}};

// Three planes: the root with a triangle in its plane and one on either side of it.
inline constexpr Triangle kFourTriangles[] = {{0, 1, 2}, {0, 2, 3}, {0, 1, 3}, {1, 2, 3}};
inline constexpr BspNode kNodes[] = {
    {1, -2, 3, -4, 0, 1, 2, 0}, {5, 6, 7, 0x40000000, 1, 0, 0, 0}, {-8, 9, 10, 11, 3, 0, 0, 0}};

inline constexpr Segment kSegments[] = {{0, 1}, {1, 2}, {3, 3}};
inline constexpr LineSet kLines[] = {
    {.segments = kSegments, .mesh = 1, .material = 1, .transform = Transform::identity(), .width = 64},
    {.segments = {}, .material = 1, .transform = {{{1, -2, 3, -4}, {5, 6, 7, 8}, {9, 10, 11, -70000}}}}};
inline constexpr Edge kEdges[] = {{0, 1, 2}, {2, 0, 1, 3}, {1, 2, 0, 0x302}};
inline constexpr EdgeSet kEdgeSets[] = {{.edges = std::span(kEdges).first(2), .mesh = 0}, {.edges = {}, .mesh = 1}};
inline constexpr Outline kOutlines[] = {{.colour = {1, 2, 3, 4}, .width = 40}};
inline constexpr Shadow kShadow{.light = 1, .log2_size = 5, .bias = 77};
inline constexpr Turn kTurn{.what = Turning::instances, .still_instances = 2};
inline constexpr Camera kTurningCamera{.eye = {1, -2, 300000}, .focal = 70000, .fixed_depth_range = true};

// Two skins of two joints, and two clips: one moves an instance and a joint, the other two joints.
inline constexpr Mesh kBindMeshes[] = {
    {kPositions, kNormals, {}, {}, kTriangles, kMeshlets, {100, -200, 300}, {65536, 65536, 65536}, 12},
    {kPositions, {}, {}, {}, kTriangles, {}, {0, 0, 0}, {70000, 70000, 70000}, 4}};
inline constexpr Joint kJoints[] = {{{{{60000, 1, 2, 3}, {4, 60000, 5, -6}, {7, 8, 60000, 9}}}, kNoJoint},
                                    {Transform::identity(), 0}};
inline constexpr JointPose kRest[] = {{{0, 0, 0, 32767}, {100, 200, -300}, {65536, 65536, 65536}},
                                      {{0, 23170, 0, 23170}, {-1, 2, 3}, {60000, 65536, 70000}}};
inline constexpr VertexJoints kVertexJoints[] = {{{0, 1, 0, 0}, {155, 100, 0, 0}},
                                                 {{1, 0, 0, 0}, {255, 0, 0, 0}},
                                                 {{0, 1, 0, 1}, {100, 80, 50, 25}},
                                                 {{1, 1, 1, 1}, {255, 0, 0, 0}}};
inline constexpr Skin kSkins[] = {
    {.mesh = &kBindMeshes[0], .vertices = kVertexJoints, .joints = kJoints, .rest = kRest},
    {.mesh = &kBindMeshes[1], .vertices = kVertexJoints, .joints = kJoints, .rest = kRest}};
inline constexpr Keyframe kWalkKeys[] = {{0, {0, 0, 0, 32767}, {10, 20, 30}, {65536, 65536, 65536}},
                                         {900, {0, 23170, 0, 23170}, {-10, 0, 300}, {65536, 65536, 65536}},
                                         {100, {0, 0, 23170, 23170}, {1, 2, 3}, {50000, 65536, 65536}}};
inline constexpr Keyframe kWaveKeys[] = {{5, {32767, 0, 0, 0}, {7, 8, 9}, {65536, 65536, 65536}},
                                         {0, {0, 0, 0, 32767}, {0, 0, 0}, {65536, 65536, 40000}},
                                         {300, {23170, 0, 0, 23170}, {0, 0, 1000}, {65536, 65536, 40000}}};
inline constexpr Track kWalkInstances[] = {{.instance = 2, .count = 2, .first = 0}};
inline constexpr Track kWalkJoints[] = {{.instance = 1, .count = 1, .first = 2}};
inline constexpr Track kWaveJoints[] = {{.instance = 1, .count = 1, .first = 0},
                                        {.instance = 0, .count = 2, .first = 1}};
inline constexpr Clip kClips[] = {
    {.name = "walk", .instances = {kWalkInstances, kWalkKeys, 1000}, .joints = {kWalkJoints, kWalkKeys, 1000}},
    {.name = "w\xC3\xA4ve", .instances = {{}, {}, 700}, .joints = {kWaveJoints, kWaveKeys, 700}}};
/// What skin_bytes() needs.
inline constexpr std::size_t kSkinMemory =
    scene_blob_memory(2, 2) + character_memory({.skins = 2, .joints = 2, .clips = 2, .positions = 4, .normals = 4});

// Morph targets of both meshes of the skins: two of the first one, also of normals, and one of the second one.
inline constexpr MorphRun kMorphRuns[] = {{0, 1, 0}, {2, 2, 1}, {1, 1, 0}, {0, 4, 0}};
inline constexpr MorphOffset kMorphOffsets[] = {{100, -200, 300}, {1, 2, 3}, {-32768, 4, 32767}, {5, 6, -7},
                                                {8, 9, 10},       {0, 0, 1}, {-1, 0, 0},         {0, 300, 0}};
inline constexpr NormalOffset kNormalOffsets[] = {{1, -2, 3}, {-128, 127, 0}, {4, 5, 6}};
inline constexpr MorphTarget kMorphTargets[] = {
    {.weight = 1,
     .runs = std::span(kMorphRuns).first(2),
     .positions = std::span(kMorphOffsets).first(3),
     .normals = kNormalOffsets},
    {.weight = 0, .runs = std::span(kMorphRuns).subspan(2, 1), .positions = std::span(kMorphOffsets).subspan(3, 1)},
    {.weight = 2, .runs = std::span(kMorphRuns).subspan(3, 1), .positions = std::span(kMorphOffsets).subspan(4, 4)}};
inline constexpr MovedMorph kMovedMorphs[] = {
    {.morph = {&kBindMeshes[0], std::span(kMorphTargets).first(2)}, .vertices = {}, .mesh = 0},
    {.morph = {&kBindMeshes[1], std::span(kMorphTargets).subspan(2)}, .vertices = {}, .mesh = 1}};
inline constexpr WeightKey kWalkWeightKeys[] = {{0, 0}, {500, 4096}};
inline constexpr WeightKey kWaveWeightKeys[] = {{7, -100}, {0, 4096}, {300, -2000}};
inline constexpr Track kWalkWeights[] = {{.instance = 1, .count = 2, .first = 0}};
inline constexpr Track kWaveWeights[] = {{.instance = 0, .count = 1, .first = 0},
                                         {.instance = 2, .count = 2, .first = 1}};
inline constexpr Clip kMorphClips[] = {{.name = "walk",
                                        .instances = {kWalkInstances, kWalkKeys, 1000},
                                        .joints = {kWalkJoints, kWalkKeys, 1000},
                                        .weights = {kWalkWeights, kWalkWeightKeys, 1000}},
                                       {.name = "wave",
                                        .instances = {{}, {}, 700},
                                        .joints = {kWaveJoints, kWaveKeys, 700},
                                        .weights = {kWaveWeights, kWaveWeightKeys, 700}}};
inline constexpr ClipEvent kEvents[] = {{0, 7, 0}, {0, 65535, 999}, {1, 3, 699}};
/// The memory that morph_bytes() needs.
inline constexpr std::size_t kMorphMemory =
    kSkinMemory +
    character_memory(
        {.morphs = 2, .targets = 3, .weights = 3, .morphed_positions = 8, .morphed_normals = 4, .morphed_meshlets = 2});

SceneBlob sample();
SceneBlob skin_sample();
SceneBlob morph_sample();
/// Those of sample(); with kWithPalettes for textures; with the tree of kNodes over kFourTriangles; with kLines,
/// kOutlines and kShadow; the same with kTurn and kTurningCamera, of a picture with depth as z24; with kEdgeSets; those
/// of skin_sample(); those of morph_sample(), which are both.
Bytes sample_bytes();
Bytes palette_bytes();
Bytes tree_bytes();
Bytes lines_bytes();
Bytes turn_bytes();
Bytes edges_bytes();
Bytes skin_bytes();
Bytes morph_bytes();

template <class Record>
void expect_same_bytes(std::span<const Record> actual, std::span<const Record> expected) {
  ASSERT_EQ(actual.size(), expected.size());
  const auto bytes = [](std::span<const Record> records) { return std::as_bytes(records); };
  EXPECT_TRUE(std::ranges::equal(bytes(actual), bytes(expected)));
}

struct Opened {
  Exact blob, memory;
  SceneBlob content;
  Status status;
  explicit Opened(const Bytes& bytes, std::size_t lent = scene_blob_memory(2, 2)) : blob(bytes), memory(lent) {
    status = open_scene_blob(blob.span(), memory.span(), content);
  }
};

}  // namespace zstrip::sim::test
