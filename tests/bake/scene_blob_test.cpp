// Scene blobs: every byte is where docs/formats.md says, what is written is read in place, and no bytes whatever do
// harm.
#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <memory>
#include <tuple>
#include <vector>

#include "bake/scene_blob.hpp"
#include "zstrip/base/crc32.hpp"
#include "zstrip/frame/renderer.hpp"
#include "zstrip/plan/plan.hpp"
#include "zstrip/scene/scene_blob.hpp"

namespace zstrip::sim::test {
namespace {

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

void put_word(Bytes& bytes, std::size_t at, std::uint32_t value) {
  for (std::size_t i = 0; i < 4; ++i) bytes[at + i] = static_cast<std::uint8_t>(value >> 8 * i);
}
std::uint32_t word(const Bytes& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value |= std::uint32_t{bytes[at + i]} << 8 * i;
  return value;
}
/// Makes size and checksum right again.
void mend(Bytes& bytes) {
  put_word(bytes, 4, static_cast<std::uint32_t>(bytes.size()));
  put_word(bytes, 8, static_cast<std::uint32_t>(::crc32(0, bytes.data() + 12, static_cast<uInt>(bytes.size() - 12))));
}

// Two quads with everything that a mesh can have, two textures, two materials, three instances, two lights.
constexpr Position kPositions[] = {
    {-32767, -30000, 5}, {32767, -30000, -5}, {32767, 30000, 7}, {-32767, 30000, -32767}};
constexpr Normal kNormals[] = {{0, 0, 127, 0}, {0, 127, 0, 1}, {-128, 0, 0, 2}, {1, 2, 3, 4}};
constexpr Colour kColours[] = {{255, 0, 0, 255}, {0, 255, 0, 255}, {0, 0, 255, 254}, {9, 8, 7, 6}};
constexpr TexCoord kTexcoords[] = {{0, 0}, {4096, 0}, {4096, -4096}, {0, 4096}};
constexpr Triangle kTriangles[] = {{0, 1, 2}, {0, 2, 3}};
constexpr Meshlet kMeshlets[] = {{0, 0, 4, 1, 40000, {1, -2, 3}}, {1, 0, 4, 1, 65535, {-4, 5, -6}}};
constexpr std::uint16_t kTexels[] = {0xF800, 0x07E0, 0x001F, 0xFFFF};
constexpr Mesh kMeshes[] = {
    {kPositions, kNormals, kColours, kTexcoords, kTriangles, kMeshlets, {100, -200, 300}, {65536, 70000, 1}, 12},
    {kPositions, {}, {}, {}, kTriangles, {}, {0, 0, 0}, {65536, 65536, 65536}, 4}};
constexpr std::uint16_t kTexelsWithAlpha[] = {0xF800, 0x07E0, 0x001F, 0xFFFF, 0x8000, 0xFF40};
constexpr Texture kTextures[] = {{kTexelsWithAlpha, 1, 1, TextureFormat::rgb565_alpha}, {kTexels, 2, 0}};
constexpr Material kMaterials[] = {{.colour = {1, 2, 3, 4}, .texture = 1},
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
constexpr Instance kInstances[] = {{0, 0, Transform::identity()},
                                   {1, 1, {{{1, -2, 3, -4}, {5, 6, 7, 8}, {9, 10, 11, -70000}}}},
                                   {0, 1, {{{30000, 0, 0, 50000}, {0, 30000, 0, 0}, {0, 0, 30000, 0}}}}};
constexpr DirectionalLight kLights[] = {{1, -2, 32767, {10, 20, 30, 40}}, {-32767, 0, 0, {50, 60, 70, 80}}};

constexpr Finish kFinishes[] = {{},
                                {.emissive = {1, 2, 3, 4},
                                 .specular = {5, 6, 7, 8},
                                 .shininess = 9,
                                 .alpha_mode = AlphaMode::mask,
                                 .alpha_cutoff = 10,
                                 .filter = TextureFilter::bilinear}};
constexpr PunctualLight kPunctualLights[] = {{.colour = {9, 8, 7, 6}, .position = {1, -2, 3}},
                                             {.type = PunctualLightType::spot,
                                              .intensity = 70000,
                                              .range = 80000,
                                              .x = 1,
                                              .y = -2,
                                              .z = 3,
                                              .cosine_inner = 30000,
                                              .cosine_outer = 20000}};
constexpr Fog kFog{.colour = {4, 3, 2, 1}, .mode = FogMode::exponential, .start = 5, .end = 600000, .density = 7000};

SceneBlob sample() {
  SceneBlob blob{.scene = {.meshes = kMeshes,
                           .materials = kMaterials,
                           .textures = kTextures,
                           .instances = kInstances,
                           .lights = kLights,
                           .ambient = {11, 12, 13, 14},
                           .background = {15, 16, 17, 18},
                           .fog = &kFog,
                           .finishes = kFinishes,
                           .punctual_lights = kPunctualLights},
                 .camera = {},
                 .view = {320, 200, PixelFormat::gray4, true}};
  EXPECT_TRUE(look_at(blob.camera, {20000, 30000, 250000}, {0, 0, 0}, {0, kFixedOne, 0}));
  blob.camera.fixed_depth_range = true;
  return blob;
}

Bytes sample_bytes() {
  const Result<Bytes> bytes = to_scene_blob(sample());
  EXPECT_TRUE(bytes);
  return bytes ? *bytes : Bytes{};
}

struct Opened {
  Exact blob, memory;
  SceneBlob content;
  Status status;
  explicit Opened(const Bytes& bytes, std::size_t lent = scene_blob_memory(2, 2)) : blob(bytes), memory(lent) {
    status = open_scene_blob(blob.span(), memory.span(), content);
  }
};

TEST(SceneBlob, ChecksumIsZlibs) {
  EXPECT_EQ(zstrip::crc32({}), 0U);
  Bytes bytes;
  for (int i = 0; i < 1000; ++i) {
    bytes.push_back(static_cast<std::uint8_t>(i * i * 7 + i));
    ASSERT_EQ(zstrip::crc32(std::as_bytes(std::span(bytes))),
              ::crc32(0, bytes.data(), static_cast<uInt>(bytes.size())));
  }
}

/// Written by hand from docs/formats.md: one red triangle and an orthographic camera.
TEST(SceneBlob, GoldenBytes) {
  // clang-format off
  Bytes expected{
      'z', 's', 3, 's',  0, 0, 0, 0,  0, 0, 0, 0,
      192, 0, 0, 0, 1, 0, 0, 0,   12, 1, 0, 0, 1, 0, 0, 0,   0, 0, 0, 0, 0, 0, 0, 0,   // meshes, materials, textures
      36, 1, 0, 0, 1, 0, 0, 0,   0, 0, 0, 0, 0, 0, 0, 0,                                // instances, lights
      48, 48, 48, 255,  1, 2, 3, 4,                                                     // ambient, background
      0, 0, 0, 64, 0, 0, 0, 0, 0, 0, 0, 0,   0, 0, 0, 0, 0, 0, 0, 64, 0, 0, 0, 0,       // right, up
      0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 64,   0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 3, 0,        // back, eye
      0x68, 0xBB, 1, 0,  0x9A, 0x19, 0, 0,  0, 0, 100, 0,  1, 0, 0, 0,                  // focal, near, far; orthographic
      64, 1, 240, 0, 1, 0, 0, 0,                                                        // 320x240, rgb565_swapped
      0, 0, 0, 0, 0, 0, 0, 0,  0, 0, 0, 0, 0, 0, 0, 0,  0, 0, 0, 0,                      // tracks, keyframes, duration
      0, 0, 0, 0, 0, 0, 0, 0,  0, 0, 0, 0, 0, 0, 0, 0,  0, 0, 0, 0, 0, 0, 0, 0,          // finishes, punctual lights, fog
      0, 0, 0, 0, 0, 0, 0, 0,  0, 0, 0, 0, 0, 0, 0, 0,                                  // quadrics, nodes of a tree
      // 192: the mesh
      88, 1, 0, 0, 3, 0, 0, 0,   0, 0, 0, 0, 0, 0, 0, 0,   0, 0, 0, 0, 0, 0, 0, 0,   0, 0, 0, 0, 0, 0, 0, 0,
      108, 1, 0, 0, 1, 0, 0, 0,   0, 0, 0, 0, 0, 0, 0, 0,
      0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,   0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0,   12, 0, 0, 0,
      // 268: the material
      255, 0, 0, 255,  255, 255,  0, 1, 0, 1, 1, 255,  0, 0, 0, 0,  0, 0, 0, 0,  0, 0, 0, 0,
      // 292: the instance
      0, 0, 0, 0,  0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,  0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0,
      0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0,
      // 344: positions, and two bytes up to the next multiple of 4; 364: the triangle, likewise
      0, 128, 0, 0, 1, 0,  255, 127, 0, 0, 0, 0,  0, 0, 255, 127, 0, 0,  0, 0,
      0, 0, 1, 0, 2, 0,  0, 0};
  // clang-format on
  mend(expected);
  ASSERT_EQ(expected.size(), 372U);

  constexpr Position kCorners[] = {{-32768, 0, 1}, {32767, 0, 0}, {0, 32767, 0}};
  constexpr Triangle kTriangle[] = {{0, 1, 2}};
  const Mesh mesh[] = {
      {.positions = kCorners, .normals = {}, .colours = {}, .texcoords = {}, .triangles = kTriangle, .meshlets = {}}};
  const Material material[] = {{.colour = {255, 0, 0, 255}, .lit = false}};
  const Instance instance[] = {{}};
  const SceneBlob content{.scene = {.meshes = mesh,
                                    .materials = material,
                                    .textures = {},
                                    .instances = instance,
                                    .lights = {},
                                    .background = {1, 2, 3, 4}},
                          .camera = {.projection = Projection::orthographic},
                          .view = {320, 240, PixelFormat::rgb565_swapped}};
  const Result<Bytes> written = to_scene_blob(content);
  ASSERT_TRUE(written);
  EXPECT_EQ(*written, expected);

  const Opened opened(expected, scene_blob_memory(1, 0));
  ASSERT_TRUE(opened.status) << message(opened.status.error) << ' ' << opened.status.needed;
  EXPECT_EQ(opened.content.scene.meshes[0].positions[0].x, -32768);
  EXPECT_EQ(opened.content.scene.materials[0].colour, (Colour{255, 0, 0, 255}));
  EXPECT_EQ(opened.content.camera.focal, Camera{}.focal);
  EXPECT_EQ(opened.content.view.width, 320);
  EXPECT_FALSE(opened.content.view.dither);
}

template <class Record>
void expect_same_bytes(std::span<const Record> actual, std::span<const Record> expected) {
  ASSERT_EQ(actual.size(), expected.size());
  const auto bytes = [](std::span<const Record> records) { return std::as_bytes(records); };
  EXPECT_TRUE(std::ranges::equal(bytes(actual), bytes(expected)));
}

TEST(SceneBlob, WhatIsWrittenIsReadInPlace) {
  const SceneBlob expected = sample();
  Opened opened(sample_bytes());
  ASSERT_TRUE(opened.status) << message(opened.status.error) << ' ' << opened.status.needed;
  const Scene& scene = opened.content.scene;
  ASSERT_EQ(scene.meshes.size(), 2U);
  const std::byte* const begin = opened.blob.bytes.get();
  const std::byte* const end = begin + opened.blob.size;
  const auto in_place = [&](const auto& array) {
    const auto* const first = reinterpret_cast<const std::byte*>(array.data());
    return array.empty() || (first >= begin && first + array.size_bytes() <= end);
  };
  for (std::size_t i = 0; i < 2; ++i) {
    const Mesh& mesh = scene.meshes[i];
    expect_same_bytes(mesh.positions, kMeshes[i].positions);
    expect_same_bytes(mesh.normals, kMeshes[i].normals);
    expect_same_bytes(mesh.colours, kMeshes[i].colours);
    expect_same_bytes(mesh.texcoords, kMeshes[i].texcoords);
    expect_same_bytes(mesh.triangles, kMeshes[i].triangles);
    ASSERT_EQ(mesh.meshlets.size(), kMeshes[i].meshlets.size());
    for (std::size_t m = 0; m < mesh.meshlets.size(); ++m) {
      EXPECT_EQ(mesh.meshlets[m].first_triangle, kMeshlets[m].first_triangle);
      EXPECT_EQ(mesh.meshlets[m].vertex_count, kMeshlets[m].vertex_count);
      EXPECT_EQ(mesh.meshlets[m].triangle_count, kMeshlets[m].triangle_count);
      EXPECT_EQ(mesh.meshlets[m].radius, kMeshlets[m].radius);
      EXPECT_EQ(mesh.meshlets[m].centre.z, kMeshlets[m].centre.z);
    }
    EXPECT_EQ(mesh.centre, kMeshes[i].centre);
    EXPECT_EQ(mesh.half_extent, kMeshes[i].half_extent);
    EXPECT_EQ(mesh.texcoord_bits, kMeshes[i].texcoord_bits);
    EXPECT_TRUE(in_place(mesh.positions) && in_place(mesh.normals) && in_place(mesh.colours) &&
                in_place(mesh.texcoords) && in_place(mesh.triangles) && in_place(mesh.meshlets));
  }
  ASSERT_EQ(scene.textures.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    expect_same_bytes(scene.textures[i].texels, kTextures[i].texels);
    EXPECT_EQ(scene.textures[i].log2_width, kTextures[i].log2_width);
    EXPECT_EQ(scene.textures[i].log2_height, kTextures[i].log2_height);
    EXPECT_EQ(scene.textures[i].format, kTextures[i].format);
    EXPECT_TRUE(in_place(scene.textures[i].texels));
  }
  ASSERT_EQ(scene.materials.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const Material &actual = scene.materials[i], &wanted = kMaterials[i];
    EXPECT_EQ(actual.colour, wanted.colour);
    EXPECT_EQ(actual.texture, wanted.texture);
    EXPECT_EQ(actual.lit, wanted.lit);
    EXPECT_EQ(actual.smooth, wanted.smooth);
    EXPECT_EQ(actual.double_sided, wanted.double_sided);
    EXPECT_EQ(actual.depth_test, wanted.depth_test);
    EXPECT_EQ(actual.depth_write, wanted.depth_write);
    EXPECT_EQ(actual.finish, wanted.finish);
    EXPECT_EQ(actual.depth_bias, wanted.depth_bias);
    EXPECT_EQ(actual.depth_slope_bias, wanted.depth_slope_bias);
    EXPECT_EQ(actual.depth_bias_clamp, wanted.depth_bias_clamp);
  }
  expect_same_bytes(scene.instances, std::span<const Instance>(kInstances));
  expect_same_bytes(scene.lights, std::span<const DirectionalLight>(kLights));
  EXPECT_TRUE(in_place(scene.materials) && in_place(scene.instances) && in_place(scene.lights));
  expect_same_bytes(scene.finishes, std::span<const Finish>(kFinishes));
  ASSERT_EQ(scene.punctual_lights.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const PunctualLight &actual = scene.punctual_lights[i], &wanted = kPunctualLights[i];
    EXPECT_EQ(actual.type, wanted.type);
    EXPECT_EQ(actual.colour, wanted.colour);
    EXPECT_EQ(actual.position, wanted.position);
    EXPECT_EQ(actual.intensity, wanted.intensity);
    EXPECT_EQ(actual.range, wanted.range);
    EXPECT_EQ(std::tuple(actual.x, actual.y, actual.z), std::tuple(wanted.x, wanted.y, wanted.z));
    EXPECT_EQ(actual.cosine_inner, wanted.cosine_inner);
    EXPECT_EQ(actual.cosine_outer, wanted.cosine_outer);
  }
  ASSERT_NE(scene.fog, nullptr);
  EXPECT_EQ(scene.fog->colour, kFog.colour);
  EXPECT_EQ(scene.fog->mode, kFog.mode);
  EXPECT_EQ(std::tuple(scene.fog->start, scene.fog->end, scene.fog->density),
            std::tuple(kFog.start, kFog.end, kFog.density));
  EXPECT_TRUE(in_place(scene.finishes) && in_place(scene.punctual_lights));
  EXPECT_EQ(scene.ambient, expected.scene.ambient);
  EXPECT_EQ(scene.background, expected.scene.background);
  EXPECT_EQ(opened.content.camera.right, expected.camera.right);
  EXPECT_EQ(opened.content.camera.up, expected.camera.up);
  EXPECT_EQ(opened.content.camera.back, expected.camera.back);
  EXPECT_EQ(opened.content.camera.eye, expected.camera.eye);
  EXPECT_EQ(opened.content.camera.near_plane, expected.camera.near_plane);
  EXPECT_EQ(opened.content.camera.far_plane, expected.camera.far_plane);
  EXPECT_TRUE(opened.content.camera.fixed_depth_range);
  EXPECT_EQ(opened.content.view.height, 200);
  EXPECT_EQ(opened.content.view.format, PixelFormat::gray4);
  EXPECT_TRUE(opened.content.view.dither);
}

TEST(SceneBlob, DitheringIsAFlagThatOlderBlobsDoNotHave) {
  Bytes bytes = sample_bytes();
  EXPECT_EQ(bytes[129], 1);
  const auto with = [&bytes](std::uint8_t value) {
    bytes[129] = value;
    mend(bytes);
    return Opened(bytes);
  };
  EXPECT_TRUE(with(0).status);
  EXPECT_FALSE(with(0).content.view.dither);
  EXPECT_EQ(with(2).status, (Status{.error = Error::blob_damaged, .needed = 129}));
}

// A palette of 16 colours for 4 texels, one of 256 for as many.
constexpr auto kFourBits = [] {
  std::array<std::uint16_t, 17> words{0xF800, 0x07E0, 0x001F};
  words[16] = 0xF210;
  return words;
}();
constexpr std::array<std::uint16_t, 258> kEightBits{0x1111, 0x2222};
constexpr Texture kWithPalettes[] = {{kFourBits, 1, 1, TextureFormat::palette4},
                                     {kEightBits, 1, 1, TextureFormat::palette8}};

Bytes palette_bytes() {
  std::vector<Material> materials(std::begin(kMaterials), std::end(kMaterials));
  materials[0].finish = 0;  // which the one with a texture needs
  SceneBlob blob = sample();
  blob.scene.materials = materials;
  blob.scene.textures = kWithPalettes;
  const Result<Bytes> bytes = to_scene_blob(blob);
  EXPECT_TRUE(bytes);
  return bytes ? *bytes : Bytes{};
}

TEST(SceneBlob, PalettesAreOfANewVersion) {
  EXPECT_EQ(sample_bytes()[2], 3);
  Bytes bytes = palette_bytes();
  EXPECT_EQ(bytes[2], 4);
  const Opened opened(bytes);
  ASSERT_TRUE(opened.status);
  expect_same_bytes(opened.content.scene.textures[0].texels, kWithPalettes[0].texels);
  expect_same_bytes(opened.content.scene.textures[1].texels, kWithPalettes[1].texels);
  EXPECT_EQ(opened.content.scene.textures[0].format, TextureFormat::palette4);
  EXPECT_EQ(opened.content.scene.textures[1].format, TextureFormat::palette8);

  const std::uint32_t format = word(bytes, 28) + 10;  // of the first texture
  EXPECT_EQ(bytes[format], 3);
  bytes[2] = 3;
  EXPECT_EQ(Opened(bytes).status, (Status{.error = Error::blob_damaged, .needed = format})) << "it has none";
  bytes[2] = 4;
  bytes[format] = 4;
  mend(bytes);
  EXPECT_EQ(Opened(bytes).status, (Status{.error = Error::blob_damaged, .needed = format}));
}

TEST(SceneBlob, PalettesNeedAllTheirWords) {
  const Bytes whole = palette_bytes();
  const std::uint32_t textures = word(whole, 28);
  for (std::uint32_t i = 0; i < 2; ++i) {
    for (const std::uint32_t words : {0U, 1U, 15U, i == 0 ? 16U : 257U}) {
      Bytes fewer = whole;
      put_word(fewer, textures + 12 * i + 4, words);
      if (words == 0) put_word(fewer, textures + 12 * i, 0);
      mend(fewer);
      EXPECT_EQ(Opened(fewer).status, (Status{.error = Error::texture, .needed = i})) << words;
    }
    Bytes larger = whole;
    larger[textures + 12 * i + 8] = 11;  // 2048 texels across
    mend(larger);
    EXPECT_EQ(Opened(larger).status, (Status{.error = Error::texture, .needed = i}));
  }
}

// Three planes: the root with a triangle in its plane and one on either side of it.
constexpr Triangle kFourTriangles[] = {{0, 1, 2}, {0, 2, 3}, {0, 1, 3}, {1, 2, 3}};
constexpr BspNode kNodes[] = {
    {1, -2, 3, -4, 0, 1, 2, 0}, {5, 6, 7, 0x40000000, 1, 0, 0, 0}, {-8, 9, 10, 11, 3, 0, 0, 0}};

Bytes tree_bytes() {
  constexpr Mesh kMesh[] = {{kPositions, {}, {}, {}, kFourTriangles, {}, {0, 0, 0}, {65536, 65536, 65536}, 12}};
  SceneBlob blob = sample();
  blob.scene.meshes = kMesh;
  blob.scene.instances = std::span(kInstances).first(1);
  blob.tree.nodes = kNodes;
  const Result<Bytes> bytes = to_scene_blob(blob);
  EXPECT_TRUE(bytes);
  return bytes ? *bytes : Bytes{};
}

TEST(SceneBlob, ATreeStandsWhereItsArraySaysAndIsReadInPlace) {
  const Bytes bytes = tree_bytes();
  const std::uint32_t at = word(bytes, 184);
  ASSERT_EQ(word(bytes, 188), 3U);
  const std::uint32_t expected[] = {1, 0xFFFFFFFE, 3, 0xFFFFFFFC, 0,          1, 2,  0,  5, 6, 7, 0x40000000,
                                    1, 0,          0, 0,          0xFFFFFFF8, 9, 10, 11, 3, 0, 0, 0};
  for (std::uint32_t i = 0; i < 24; ++i) EXPECT_EQ(word(bytes, at + 4 * i), expected[i]) << i;
  const Opened opened(bytes);
  ASSERT_TRUE(opened.status) << message(opened.status.error) << ' ' << opened.status.needed;
  ASSERT_EQ(opened.content.tree.nodes.size(), 3U);
  EXPECT_EQ(reinterpret_cast<const std::byte*>(opened.content.tree.nodes.data()), opened.blob.bytes.get() + at);
  EXPECT_EQ(opened.content.tree.nodes[1].distance, 0x40000000);
  EXPECT_EQ(opened.content.tree.nodes[2].first_triangle, 3U);
}

TEST(SceneBlob, ATreeThatIsNoneIsDamaged) {
  const Bytes whole = tree_bytes();
  const std::uint32_t nodes = word(whole, 184);
  const auto refused_at = [&](std::uint32_t node, std::uint32_t member, std::uint32_t value, std::uint32_t byte) {
    Bytes changed = whole;
    put_word(changed, nodes + 32 * node + member, value);
    mend(changed);
    EXPECT_EQ(Opened(changed).status, (Status{.error = Error::blob_damaged, .needed = nodes + byte}))
        << node << ' ' << member << ' ' << value;
  };
  constexpr std::uint32_t kFirst = 16, kFront = 20, kBack = 24, kParent = 28;
  refused_at(0, kFirst, 1, kFirst);       // triangles that no node has
  refused_at(1, kFirst, 5, 32 + kFirst);  // beyond the mesh's four
  refused_at(2, kFirst, 0, 64 + kFirst);  // before the last node's
  for (const std::uint32_t none : {3U, 0x80000000U, 0xFFFFFFFFU}) {
    refused_at(0, kFront, none, kFront);
    refused_at(0, kBack, none, kBack);
    refused_at(1, kParent, none, kFront);
  }
  refused_at(0, kFront, 2, kBack);        // both sides are one
  refused_at(0, kBack, 0, 64 + kParent);  // nobody's child
  refused_at(1, kFront, 1, 32 + kFront);  // itself
  refused_at(1, kFront, 2, 32 + kFront);  // another's child
  refused_at(0, kParent, 1, kParent);
  Bytes several = sample_bytes();  // of a scene of three instances
  const auto at = static_cast<std::uint32_t>(several.size());
  several.insert(several.end(), 32, 0);
  put_word(several, 184, at);
  put_word(several, 188, 1);
  mend(several);
  EXPECT_EQ(Opened(several).status, (Status{.error = Error::blob_damaged, .needed = 184}));
}

/// Also where size and checksum agree with what is left.
void expect_every_part_refused(const Bytes& whole) {
  for (std::size_t length = 0; length < whole.size(); ++length) {
    Bytes part(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length));
    ASSERT_EQ(Opened(part).status.error, Error::blob_damaged) << length;
    if (length < 12) continue;
    mend(part);
    ASSERT_FALSE(Opened(part).status) << length;
  }
}

TEST(SceneBlob, TruncatedAtEveryLengthWithATree) { expect_every_part_refused(tree_bytes()); }
TEST(SceneBlob, TruncatedAtEveryLengthWithPalettes) { expect_every_part_refused(palette_bytes()); }

/// Visible sets begin like a scene, and have another version.
TEST(SceneBlob, AnotherKindIsNotAnotherVersion) {
  Bytes bytes = sample_bytes();
  bytes[2] = 1;
  bytes[3] = 'v';
  EXPECT_EQ(Opened(bytes).status, (Status{.error = Error::blob_damaged, .needed = 3}));
}

TEST(SceneBlob, TruncatedAtEveryLength) {
  expect_every_part_refused(sample_bytes());
  Bytes longer = sample_bytes();
  longer.push_back(0);
  EXPECT_EQ(Opened(longer).status.error, Error::blob_damaged);
}

TEST(SceneBlob, EveryBitFlipped) {
  const Bytes whole = sample_bytes();
  for (std::size_t at = 0; at < whole.size(); ++at) {
    for (int bit = 0; bit < 8; ++bit) {
      Bytes flipped = whole;
      flipped[at] = static_cast<std::uint8_t>(flipped[at] ^ 1 << bit);
      const Status status = Opened(flipped).status;
      ASSERT_EQ(status.error, at == 2 ? Error::blob_version : Error::blob_damaged) << at;
    }
  }
}

/// Draws whatever has opened: it has passed the same checks as any scene.
void draw(const SceneBlob& content, Effects method = {}) {
  constexpr View kView{48, 32, PixelFormat::rgb565};
  const Effects effects = effects_of(content.scene, content.camera) | method;
  const PlanResult planned = plan(count(content.scene), kView, effects, {.strip_rows = 16});
  if (!planned.status) return;
  std::vector<std::uint64_t> arena(planned.plan.bytes() / 8 + 1), pixels(planned.plan.strip_pixel_bytes(kView) / 8 + 1);
  AnyRenderer renderer(effects);
  renderer.set_visibility({.tree = &content.tree});
  if (!renderer.begin_frame(content.scene, content.camera, kView, planned.plan,
                            std::as_writable_bytes(std::span(arena)))) {
    return;
  }
  for (std::uint16_t strip = 0; strip < planned.plan.strips; ++strip) {
    EXPECT_TRUE(renderer.draw_strip(strip, std::as_writable_bytes(std::span(pixels))));
  }
}

/// Who writes a wrong value also writes its checksum.
TEST(SceneBlob, EveryByteChangedUnderARightChecksum) {
  for (const Bytes& whole : {sample_bytes(), tree_bytes(), palette_bytes()}) {
    const bool has_tree = word(whole, 184) != 0;
    std::size_t refused = 0, drawn = 0;
    for (std::size_t at = 12; at < whole.size(); ++at) {
      for (const int value : {0x00, 0x01, 0x02, 0x7F, 0x80, 0xFF}) {
        Bytes changed = whole;
        changed[at] = static_cast<std::uint8_t>(value);
        mend(changed);
        const Opened opened(changed, scene_blob_memory(300, 300));
        if (!opened.status) {
          ++refused;
          continue;
        }
        ++drawn;
        draw(opened.content, has_tree ? method::painter | method::bsp : Effects{});
      }
    }
    EXPECT_GT(refused, 300U);
    EXPECT_GT(drawn, 300U);
  }
}

TEST(SceneBlob, ArraysBeyondTheEnd) {
  const Bytes whole = sample_bytes();
  const std::uint32_t meshes = word(whole, 12);
  for (std::size_t entry :
       {std::size_t{12}, std::size_t{20}, std::size_t{28}, std::size_t{36}, std::size_t{44}, std::size_t{132},
        std::size_t{140}, std::size_t{152}, std::size_t{160}, std::size_t{168}, std::size_t{176}, std::size_t{184},
        std::size_t{meshes}, std::size_t{meshes} + 8, std::size_t{meshes} + 40}) {
    for (const std::uint32_t value :
         {0xFFFFFFFFU, 0xFFFFFFFCU, 0x80000000U, 0x7FFFFFFCU, static_cast<std::uint32_t>(whole.size()),
          static_cast<std::uint32_t>(whole.size()) - 4, 128U, 130U}) {
      Bytes offset = whole;
      put_word(offset, entry, value);
      mend(offset);
      EXPECT_FALSE(Opened(offset).status) << entry << ' ' << value;
      Bytes count = whole;
      put_word(count, entry + 4, value | 0x10000);
      mend(count);
      const Status status = Opened(count).status;
      EXPECT_EQ(status.error, Error::blob_damaged) << entry << ' ' << value;
      EXPECT_EQ(status.needed, entry);
    }
  }
}

TEST(SceneBlob, ValuesThatAreNone) {
  const Bytes whole = sample_bytes();
  const std::size_t material = word(whole, 20);
  const auto error_with = [&whole](std::size_t at, std::uint8_t value) {
    Bytes changed = whole;
    changed[at] = value;
    mend(changed);
    return Opened(changed).status;
  };
  for (const std::size_t flag :
       {material + 6, material + 7, material + 8, material + 10, std::size_t{120}, std::size_t{121}}) {
    EXPECT_EQ(error_with(flag, 2), (Status{.error = Error::blob_damaged, .needed = static_cast<std::uint32_t>(flag)}));
  }
  EXPECT_EQ(error_with(material + 9, 8).error, Error::blob_damaged);  // depth test
  EXPECT_EQ(error_with(128, static_cast<std::uint8_t>(kLastPixelFormat) + 1).error, Error::blob_damaged);
  EXPECT_EQ(error_with(125, 17).error, Error::blob_damaged);  // 4416 pixels wide
  EXPECT_EQ(error_with(3, 'd').error, Error::blob_damaged);
  EXPECT_EQ(error_with(2, 1), (Status{.error = Error::blob_version, .needed = 1, .available = 4}));
  EXPECT_EQ(error_with(111, 0x80).error, Error::camera);  // negative focal length
}

TEST(SceneBlob, LentMemory) {
  const Bytes whole = sample_bytes();
  const std::size_t needed = scene_blob_memory(2, 2);
  EXPECT_EQ(needed, 2 * sizeof(Mesh) + 2 * sizeof(Texture));
  EXPECT_TRUE(Opened(whole, needed).status);
  for (std::size_t lent = 0; lent < needed; ++lent) {
    EXPECT_EQ(Opened(whole, lent).status, (Status{.error = Error::blob_memory,
                                                  .needed = static_cast<std::uint32_t>(needed),
                                                  .available = static_cast<std::uint32_t>(lent)}));
  }
}

TEST(SceneBlob, Misaligned) {
  const Bytes whole = sample_bytes();
  Exact shifted(whole.size() + 4), memory(scene_blob_memory(2, 2) + 16);
  SceneBlob content;
  for (std::size_t shift = 1; shift < 4; ++shift) {
    std::memcpy(shifted.bytes.get() + shift, whole.data(), whole.size());
    EXPECT_EQ(open_scene_blob(shifted.span().subspan(shift, whole.size()), memory.span(), content).error,
              Error::blob_alignment);
  }
  Exact blob(whole);
  EXPECT_EQ(open_scene_blob(blob.span(), memory.span().subspan(2), content).error, Error::blob_alignment);
  EXPECT_TRUE(content.scene.meshes.empty()) << "a failure changes nothing";
  EXPECT_TRUE(open_scene_blob(blob.span(), memory.span(), content));
}

}  // namespace
}  // namespace zstrip::sim::test
