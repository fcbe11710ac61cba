// Scene blobs: every byte is where docs/formats.md says, and what is written is read in place.
#include <gtest/gtest.h>
#include <zlib.h>

#include <cstdint>
#include <vector>

#include "bake/scene_blob.hpp"
#include "blob_sample.hpp"
#include "zstrip/base/crc32.hpp"
#include "zstrip/blob.hpp"

namespace zstrip::sim::test {
namespace {

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
      'z', 's', 5, 's',  0, 0, 0, 0,  0, 0, 0, 0,  8, 0, 0, 0,
      'B', 'A', 'S', 'E',  112, 0, 0, 0,   8, 0, 0, 0,
      'C', 'A', 'M', 'R',  120, 0, 0, 0,  64, 0, 0, 0,
      'I', 'N', 'S', 'T',  184, 0, 0, 0,  52, 0, 0, 0,
      'M', 'A', 'T', 'L',  236, 0, 0, 0,  24, 0, 0, 0,
      'M', 'E', 'S', 'H',    4, 1, 0, 0,  76, 0, 0, 0,
      'P', 'I', 'C', 'T',   80, 1, 0, 0,   8, 0, 0, 0,
      'P', 'O', 'S', 'I',   88, 1, 0, 0,  18, 0, 0, 0,
      'T', 'R', 'I', 'A',  108, 1, 0, 0,   6, 0, 0, 0,
      // 112: ambient, background
      48, 48, 48, 255,  1, 2, 3, 4,
      // 120: the camera's right, up, back, eye, focal length, near, far; orthographic
      0, 0, 0, 64, 0, 0, 0, 0, 0, 0, 0, 0,   0, 0, 0, 0, 0, 0, 0, 64, 0, 0, 0, 0,
      0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 64,   0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 3, 0,
      0x68, 0xBB, 1, 0,  0x9A, 0x19, 0, 0,  0, 0, 100, 0,  1, 0, 0, 0,
      // 184: the instance
      0, 0, 0, 0,  0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,  0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0,
      0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0,
      // 236: the material
      255, 0, 0, 255,  255, 255,  0, 1, 0, 1, 1, 255,  0, 0, 0, 0,  0, 0, 0, 0,  0, 0, 0, 0,
      // 260: the mesh: positions, normals, colours, texture coordinates, triangles, meshlets
      0, 0, 0, 0, 3, 0, 0, 0,   0, 0, 0, 0, 0, 0, 0, 0,   0, 0, 0, 0, 0, 0, 0, 0,   0, 0, 0, 0, 0, 0, 0, 0,
      0, 0, 0, 0, 1, 0, 0, 0,   0, 0, 0, 0, 0, 0, 0, 0,
      0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,   0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0,   12, 0, 0, 0,
      // 336: 320x240, rgb565_swapped, not dithered, one sample, nothing besides
      64, 1, 240, 0,  1, 0, 1, 0,
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

TEST(SceneBlob, PalettesAreFormatsOfTextures) {
  Bytes bytes = palette_bytes();
  const Opened opened(bytes);
  ASSERT_TRUE(opened.status);
  expect_same_bytes(opened.content.scene.textures[0].texels, kWithPalettes[0].texels);
  expect_same_bytes(opened.content.scene.textures[1].texels, kWithPalettes[1].texels);
  EXPECT_EQ(opened.content.scene.textures[0].format, TextureFormat::palette4);
  EXPECT_EQ(opened.content.scene.textures[1].format, TextureFormat::palette8);

  const std::uint32_t format = section(bytes, "TEXT") + 10;  // of the first texture
  EXPECT_EQ(bytes[format], 3);
  bytes[format] = 4;
  mend(bytes);
  EXPECT_EQ(Opened(bytes).status, (Status{.error = Error::blob_damaged, .needed = format}));
}

TEST(SceneBlob, ATreeStandsInItsSectionAndIsReadInPlace) {
  const Bytes bytes = tree_bytes();
  const std::uint32_t at = section(bytes, "tree");
  ASSERT_EQ(section_bytes(bytes, "tree"), 3U * 32);
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

}  // namespace
}  // namespace zstrip::sim::test
