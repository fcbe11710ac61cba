// Scene blobs: what effects have, in values of records and in sections of their own.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

#include "bake/scene_blob.hpp"
#include "blob_sample.hpp"
#include "zstrip/blob.hpp"
#include "zstrip/scene/validate.hpp"

namespace zstrip::sim::test {
namespace {

TEST(SceneBlob, DitheringIsAFlag) {
  Bytes bytes = sample_bytes();
  const std::uint32_t at = section(bytes, "PICT") + 5;
  EXPECT_EQ(bytes[at], 1);
  bytes[at] = 0;
  mend(bytes);
  const Opened opened(bytes);
  EXPECT_TRUE(opened.status);
  EXPECT_FALSE(opened.content.view.dither);
}

TEST(SceneBlob, WhetherAMeshIsABillboardStandsInItsRecord) {
  SceneBlob content = sample();
  std::vector<Mesh> meshes(content.scene.meshes.begin(), content.scene.meshes.end());
  meshes[1].billboard = Billboard::upright;
  content.scene.meshes = meshes;
  Bytes bytes = *to_scene_blob(content);
  const std::uint32_t at = section(bytes, "MESH");
  EXPECT_EQ(bytes[at + 73], 0);
  EXPECT_EQ(bytes[at + 76 + 73], 2);
  const Opened opened(bytes);
  ASSERT_TRUE(opened.status);
  EXPECT_EQ(opened.content.scene.meshes[0].billboard, Billboard::none);
  EXPECT_EQ(opened.content.scene.meshes[1].billboard, Billboard::upright);
  bytes[at + 73] = 3;
  mend(bytes);
  EXPECT_EQ(Opened(bytes).status, (Status{.error = Error::blob_damaged, .needed = at + 73}));
}

TEST(SceneBlob, WhetherAFinishMirrorsStandsBesideItsFilter) {
  SceneBlob content = sample();
  std::vector<Finish> finishes(content.scene.finishes.begin(), content.scene.finishes.end());
  finishes.push_back({.filter = TextureFilter::environment_bilinear});
  content.scene.finishes = finishes;
  Bytes bytes = *to_scene_blob(content);
  const std::uint32_t at = section(bytes, "FINI");
  EXPECT_EQ(bytes[at + 11], 0);
  EXPECT_EQ(bytes[at + 12 + 11], 1);
  EXPECT_EQ(bytes[at + 24 + 11], 0x11);
  const Opened opened(bytes);
  ASSERT_TRUE(opened.status);
  EXPECT_TRUE(std::ranges::equal(opened.content.scene.finishes, finishes));
  for (const int value : {0x02, 0x20, 0xF1}) {
    bytes[at + 24 + 11] = static_cast<std::uint8_t>(value);
    mend(bytes);
    EXPECT_EQ(Opened(bytes).status, (Status{.error = Error::finish, .needed = 2})) << value;
  }
}

TEST(SceneBlob, LightAtPixelsIsAThirdShading) {
  SceneBlob content = sample();
  std::vector<Material> materials(content.scene.materials.begin(), content.scene.materials.end());
  materials[1].smooth = Shading::pixel;
  content.scene.materials = materials;
  Bytes bytes = *to_scene_blob(content);
  const std::uint32_t at = section(bytes, "MATL");
  EXPECT_EQ(bytes[at + 24 + 7], 2);
  const Opened opened(bytes);
  ASSERT_TRUE(opened.status);
  EXPECT_EQ(opened.content.scene.materials[0].smooth, materials[0].smooth);
  EXPECT_EQ(opened.content.scene.materials[1].smooth, Shading::pixel);
  bytes[at + 24 + 7] = 3;
  mend(bytes);
  EXPECT_EQ(Opened(bytes).status, (Status{.error = Error::blob_damaged, .needed = at + 24 + 7}));
}

TEST(SceneBlob, OutlinesAreASection) {
  SceneBlob content = sample();
  std::vector<Mesh> meshes(content.scene.meshes.begin(), content.scene.meshes.end());
  const Outline outlines[] = {{.colour = {1, 2, 3, 4}, .width = 0x102}, {.colour = {5, 6, 7, 8}, .width = 9}};
  EXPECT_EQ(entry_of(*to_scene_blob(content), "OUTL"), 0U);
  meshes[0].outline = 2;
  content.scene.meshes = meshes;
  content.scene.instances = content.scene.instances.first(1);  // the others have a mask
  content.scene.outlines = outlines;
  EXPECT_EQ(validate(content.scene).error, Error::outline) << "258 sixteenths";
  Bytes bytes = *to_scene_blob(content);
  const std::uint32_t outline = section(bytes, "OUTL");
  EXPECT_EQ(section_bytes(bytes, "OUTL"), 16U);
  const Bytes records(bytes.begin() + outline, bytes.begin() + outline + 16);
  EXPECT_EQ(records, (Bytes{1, 2, 3, 4, 2, 1, 255, 255, 5, 6, 7, 8, 9, 0, 255, 255}));
  const std::uint32_t at = section(bytes, "MESH");
  EXPECT_EQ(bytes[at + 74], 2);
  EXPECT_EQ(bytes[at + 76 + 74], 0);
  EXPECT_EQ(Opened(bytes).status.error, Error::outline);
  bytes[outline + 4] = 0, bytes[outline + 5] = 1;
  mend(bytes);
  const Opened opened(bytes);
  ASSERT_TRUE(opened.status) << message(opened.status.error);
  EXPECT_EQ(opened.content.scene.meshes[0].outline, 2);
  EXPECT_EQ(opened.content.scene.meshes[1].outline, 0);
  ASSERT_EQ(opened.content.scene.outlines.size(), 2U);
  EXPECT_EQ(opened.content.scene.outlines[0].width, 256);
  EXPECT_EQ(opened.content.scene.outlines[1].colour, (Colour{5, 6, 7, 8}));
  EXPECT_EQ(opened.content.scene.outlines[1].hull, kOwnMesh);
}

TEST(SceneBlob, LinesAreASectionOfSetsAndOneOfSegments) {
  Bytes bytes = lines_bytes();
  EXPECT_EQ(entry_of(sample_bytes(), "LSET") | entry_of(sample_bytes(), "SEGM"), 0U);
  EXPECT_EQ(section_bytes(bytes, "LSET"), 2U * 64);
  EXPECT_EQ(section_bytes(bytes, "SEGM"), 3U * 4);
  const std::uint32_t set = section(bytes, "LSET"), next = set + 64, at = section(bytes, "SEGM");
  EXPECT_EQ(word(bytes, set), 0U) << "the first segment";
  EXPECT_EQ(word(bytes, set + 4), 3U) << "segments";
  EXPECT_EQ(Bytes(bytes.begin() + at, bytes.begin() + at + 12), (Bytes{0, 0, 1, 0, 1, 0, 2, 0, 3, 0, 3, 0}));
  EXPECT_EQ(word(bytes, set + 8), 0x10001U) << "mesh and material";
  EXPECT_EQ(word(bytes, set + 12), 65536U);
  EXPECT_EQ(word(bytes, set + 60), 64U) << "width";
  EXPECT_EQ(word(bytes, next) | word(bytes, next + 4), 0U) << "no segments";
  EXPECT_EQ(word(bytes, next + 8), 0x10000U);
  EXPECT_EQ(word(bytes, next + 12 + 44), static_cast<std::uint32_t>(-70000));

  const Opened opened(bytes, scene_blob_memory(2, 2, 2));
  ASSERT_TRUE(opened.status) << message(opened.status.error) << ' ' << opened.status.needed;
  EXPECT_EQ(scene_blob_memory(2, 2, 2) - scene_blob_memory(2, 2), 2 * sizeof(LineSet));
  EXPECT_EQ(Opened(bytes, scene_blob_memory(2, 2, 2) - 1).status.error, Error::blob_memory);
  ASSERT_EQ(opened.content.scene.lines.size(), 2U);
  EXPECT_EQ(opened.content.scene.outlines.size(), 1U);
  ASSERT_NE(opened.content.scene.shadow, nullptr);
  EXPECT_EQ(opened.content.scene.shadow->bias, kShadow.bias);
  for (std::size_t i = 0; i < 2; ++i) {
    const LineSet& actual = opened.content.scene.lines[i];
    expect_same_bytes(actual.segments, kLines[i].segments);
    EXPECT_EQ(actual.mesh, kLines[i].mesh);
    EXPECT_EQ(actual.material, kLines[i].material);
    EXPECT_EQ(std::memcmp(&actual.transform, &kLines[i].transform, sizeof(Transform)), 0);
    EXPECT_EQ(actual.width, kLines[i].width);
  }
  EXPECT_EQ(reinterpret_cast<const std::byte*>(opened.content.scene.lines[0].segments.data()),
            opened.blob.bytes.get() + at);

  const auto with = [&bytes](std::uint32_t where, std::uint8_t value) {
    Bytes changed = bytes;
    changed[where] = value;
    mend(changed);
    return Opened(changed, scene_blob_memory(2, 2, 255)).status;
  };
  EXPECT_EQ(with(set + 60, 0), (Status{.error = Error::lines, .needed = 0})) << "no width";
  EXPECT_EQ(with(next + 8, 2), (Status{.error = Error::lines, .needed = 1})) << "no such mesh";
  EXPECT_EQ(with(at + 10, 4), (Status{.error = Error::lines, .needed = 0})) << "no such vertex";
}

/// A byte counted them once.
TEST(SceneBlob, MoreSetsOfLinesThanAByteCounts) {
  const std::vector<LineSet> sets(1000, kLines[1]);
  const std::vector<Material> plain(2);
  SceneBlob content = sample();
  content.scene.materials = plain;
  content.scene.lines = sets;
  const Result<Bytes> written = to_scene_blob(content);
  ASSERT_TRUE(written);
  EXPECT_EQ(Opened(*written, scene_blob_memory(2, 2, 1000)).content.scene.lines.size(), 1000U);
}

TEST(SceneBlob, AShadowIsASection) {
  SceneBlob content = sample();
  std::vector<Mesh> meshes(content.scene.meshes.begin(), content.scene.meshes.end());
  const Shadow shadow{.light = 0, .log2_size = 9, .bias = 0x102, .slope_bias = 0x30405, .pool = 0x6070};
  EXPECT_EQ(entry_of(*to_scene_blob(content), "SHAD"), 0U);
  meshes[0].shadow = ShadowRole::only_casts;
  content.scene.meshes = meshes;
  content.scene.shadow = &shadow;
  Bytes bytes = *to_scene_blob(content);
  const std::uint32_t record = section(bytes, "SHAD"), at = section(bytes, "MESH");
  EXPECT_EQ(section_bytes(bytes, "SHAD"), 12U);
  EXPECT_EQ(Bytes(bytes.begin() + record, bytes.begin() + record + 12),
            (Bytes{0, 9, 2, 1, 5, 4, 3, 0, 0x70, 0x60, 0, 0}));
  EXPECT_EQ(bytes[at + 75], 2);
  EXPECT_EQ(bytes[at + 76 + 75], 0);
  const Opened opened(bytes);
  ASSERT_TRUE(opened.status) << message(opened.status.error);
  EXPECT_EQ(opened.content.scene.meshes[0].shadow, ShadowRole::only_casts);
  EXPECT_EQ(opened.content.scene.meshes[1].shadow, ShadowRole::casts_and_receives);
  ASSERT_NE(opened.content.scene.shadow, nullptr);
  EXPECT_EQ(opened.content.scene.shadow->log2_size, 9);
  EXPECT_EQ(opened.content.scene.shadow->bias, 0x102);
  EXPECT_EQ(opened.content.scene.shadow->slope_bias, 0x30405);
  EXPECT_EQ(opened.content.scene.shadow->pool, 0x6070U);
  Bytes wrong = bytes;
  wrong[at + 75] = 4;
  mend(wrong);
  EXPECT_EQ(Opened(wrong).status, (Status{.error = Error::blob_damaged, .needed = at + 75}));
  wrong = bytes;
  wrong[record] = 77;  // no such light
  mend(wrong);
  EXPECT_EQ(Opened(wrong).status.error, Error::shadow);
}

TEST(SceneBlob, EdgesAreASectionOfSetsAndOneOfEdges) {
  const Bytes bytes = edges_bytes();
  EXPECT_EQ(section_bytes(bytes, "ESET"), 2U * 12);
  EXPECT_EQ(section_bytes(bytes, "EDGE"), 2U * 8);
  const std::uint32_t set = section(bytes, "ESET"), at = section(bytes, "EDGE");
  EXPECT_EQ(word(bytes, set), 0U);
  EXPECT_EQ(word(bytes, set + 4), 2U);
  EXPECT_EQ(word(bytes, set + 8), 0U);
  EXPECT_EQ(word(bytes, set + 12) | word(bytes, set + 16), 0U);
  EXPECT_EQ(word(bytes, set + 20), 1U);
  EXPECT_EQ(Bytes(bytes.begin() + at, bytes.begin() + at + 16),
            (Bytes{0, 0, 1, 0, 2, 0, 255, 255, 2, 0, 0, 0, 1, 0, 3, 0}));
  const std::size_t needed = scene_blob_memory(2, 2, 0, 2);
  EXPECT_EQ(needed - scene_blob_memory(2, 2), 2 * sizeof(EdgeSet));
  const Opened opened(bytes, needed);
  ASSERT_TRUE(opened.status) << message(opened.status.error) << ' ' << opened.status.needed;
  EXPECT_EQ(Opened(bytes, needed - 1).status.error, Error::blob_memory);
  ASSERT_EQ(opened.content.scene.edges.size(), 2U);
  expect_same_bytes(opened.content.scene.edges[0].edges, kEdgeSets[0].edges);
  EXPECT_EQ(reinterpret_cast<const std::byte*>(opened.content.scene.edges[0].edges.data()),
            opened.blob.bytes.get() + at);
  EXPECT_EQ(opened.content.scene.edges[1].mesh, 1);
  const auto with = [&bytes](std::uint32_t where, std::uint32_t value) {
    Bytes changed = bytes;
    put_word(changed, where, value);
    mend(changed);
    return Opened(changed, scene_blob_memory(2, 2, 0, 2)).status;
  };
  EXPECT_EQ(with(set + 8, 2), (Status{.error = Error::edges, .needed = 0})) << "no such mesh";
  EXPECT_EQ(with(set + 20, 0), (Status{.error = Error::edges, .needed = 1})) << "twice the same mesh";
  EXPECT_EQ(with(at + 8, 0x00040002), (Status{.error = Error::edges, .needed = 0})) << "no such vertex";
}

/// A byte counted them once.
TEST(SceneBlob, MoreSetsOfEdgesThanAByteCounts) {
  const std::vector<Mesh> meshes(300, kMeshes[1]);
  std::vector<EdgeSet> sets(300);
  for (std::uint16_t i = 0; i < sets.size(); ++i) sets[i] = {.edges = kEdges, .mesh = i};
  SceneBlob content = sample();
  content.scene.meshes = meshes;
  content.scene.instances = content.scene.instances.first(1);
  content.scene.edges = sets;
  const std::size_t memory = scene_blob_memory(300, 2, 0, 300);
  EXPECT_EQ(Opened(*to_scene_blob(content), memory).status.error, Error::edges) << "0x302 is no vertex";
  for (EdgeSet& set : sets) set.edges = std::span(kEdges).first(2);
  const Bytes bytes = *to_scene_blob(content);
  EXPECT_EQ(section_bytes(bytes, "EDGE"), 2U * 8) << "sets share their edges";
  EXPECT_EQ(Opened(bytes, memory).content.scene.edges.size(), 300U);
}

/// They stood in one byte, which said which of them there are: edges beside a shadow were left out without a word.
TEST(SceneBlob, EdgesStandBesideAShadow) {
  SceneBlob content = sample();
  content.scene.shadow = &kShadow;
  content.scene.edges = kEdgeSets;
  const Bytes bytes = *to_scene_blob(content);
  const Opened opened(bytes, scene_blob_memory(2, 2, 0, 2));
  ASSERT_TRUE(opened.status) << message(opened.status.error) << ' ' << opened.status.needed;
  EXPECT_EQ(opened.content.scene.edges.size(), 2U);
  ASSERT_NE(opened.content.scene.shadow, nullptr);
  EXPECT_EQ(opened.content.scene.shadow->bias, kShadow.bias);
  // What no scene may have together is the scene's error, and not the blob's.
  constexpr CsgOperand kOperands[] = {{.instance = 0}};
  content.scene.csg = kOperands;
  EXPECT_EQ(Opened(*to_scene_blob(content), scene_blob_memory(2, 2, 0, 2)).status.error, Error::csg);
}

TEST(SceneBlob, OperandsOfProductsAreASection) {
  SceneBlob content = sample();
  const auto instances = static_cast<std::uint16_t>(content.scene.instances.size());
  const CsgOperand operands[] = {{1, 0, CsgUse::intersected},
                                 {0, 0, CsgUse::subtracted},
                                 {static_cast<std::uint16_t>(instances - 1), 9, CsgUse::intersected}};
  // Operands have no outline, no billboard and no rules of their own.
  std::vector<Mesh> meshes(content.scene.meshes.begin(), content.scene.meshes.end());
  for (Mesh& mesh : meshes) mesh.billboard = Billboard::none, mesh.outline = 0;
  std::vector<Material> materials(content.scene.materials.size(), Material{});
  content.scene.meshes = meshes;
  content.scene.materials = materials;
  content.scene.shadow = nullptr;
  const Bytes without = *to_scene_blob(content);
  content.scene.csg = operands;
  const Bytes bytes = *to_scene_blob(content);
  EXPECT_EQ(bytes.size(), without.size() + 12 + 12) << "an entry of the table, three operands";
  const std::size_t at = section(bytes, "CSGO");
  EXPECT_EQ(Bytes(bytes.begin() + static_cast<std::ptrdiff_t>(at), bytes.begin() + static_cast<std::ptrdiff_t>(at + 8)),
            (Bytes{1, 0, 0, 0, 0, 0, 0, 1}));
  const Opened opened(bytes);
  ASSERT_TRUE(opened.status) << message(opened.status.error) << ' ' << opened.status.needed;
  const std::span<const CsgOperand> read = opened.content.scene.csg;
  ASSERT_EQ(read.size(), 3U);
  EXPECT_EQ(read[1].use, CsgUse::subtracted);
  EXPECT_EQ(read[2].product, 9);
  EXPECT_EQ(read[2].instance, instances - 1);
  Bytes wrong = bytes;
  wrong[at + 7] = 2;  // no such use
  mend(wrong);
  EXPECT_EQ(Opened(wrong).status, (Status{.error = Error::csg, .needed = 1}));
}

TEST(SceneBlob, SamplesOfAPixel) {
  Bytes bytes = sample_bytes();
  const std::uint32_t at = section(bytes, "PICT") + 6;
  EXPECT_EQ(bytes[at], 1);
  for (const int samples : {1, 2, 4}) {
    bytes[at] = static_cast<std::uint8_t>(samples);
    mend(bytes);
    const Opened opened(bytes);
    ASSERT_TRUE(opened.status) << samples;
    EXPECT_EQ(opened.content.view.samples, samples);
  }
}

TEST(SceneBlob, SmallerLevelsStandInATexturesRecord) {
  Bytes bytes = palette_bytes();
  const std::uint32_t first = section(bytes, "TEXT") + 11, second = first + 12;
  EXPECT_EQ(bytes[first], 0);
  EXPECT_EQ(bytes[second], 1);
  EXPECT_EQ(Opened(bytes).content.scene.textures[0].smaller_levels, 0);
  EXPECT_EQ(Opened(bytes).content.scene.textures[1].smaller_levels, 1);
  const auto with = [&bytes](std::uint32_t at, std::uint8_t value) {
    Bytes changed = bytes;
    changed[at] = value;
    mend(changed);
    return Opened(changed).status;
  };
  EXPECT_TRUE(with(second, 0));
  EXPECT_EQ(with(first, 1), (Status{.error = Error::texture, .needed = 0})) << "its word is missing";
  for (const std::uint8_t levels : std::initializer_list<std::uint8_t>{2, 11, 32, 255}) {
    EXPECT_EQ(with(second, levels), (Status{.error = Error::texture, .needed = 1})) << "2 texels wide and high";
  }
}

}  // namespace
}  // namespace zstrip::sim::test
