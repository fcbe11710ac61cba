// Scene blobs: what came later than version 3 stands in bytes of which older blobs leave 0.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

#include "bake/scene_blob.hpp"
#include "blob_sample.hpp"
#include "zstrip/scene/scene_blob.hpp"
#include "zstrip/scene/validate.hpp"

namespace zstrip::sim::test {
namespace {

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

TEST(SceneBlob, WhetherAMeshIsABillboardStandsInAByteThatWasUnused) {
  SceneBlob content = sample();
  std::vector<Mesh> meshes(content.scene.meshes.begin(), content.scene.meshes.end());
  meshes[1].billboard = Billboard::upright;
  content.scene.meshes = meshes;
  Bytes bytes = *to_scene_blob(content);
  EXPECT_EQ(bytes[2], 3);
  const std::uint32_t at = word(bytes, 12);
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
  const std::uint32_t at = word(bytes, 152);
  EXPECT_EQ(bytes[at + 11], 0);
  EXPECT_EQ(bytes[at + 12 + 11], 1) << "as before there was a mapping";
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
  const Bytes without = *to_scene_blob(content);
  materials[1].smooth = Shading::pixel;
  content.scene.materials = materials;
  Bytes bytes = *to_scene_blob(content);
  EXPECT_EQ(bytes[2], without[2]) << "the version stays: older programs refuse the byte";
  const std::uint32_t at = word(bytes, 20);
  EXPECT_EQ(bytes[at + 24 + 7], 2);
  const Opened opened(bytes);
  ASSERT_TRUE(opened.status);
  EXPECT_EQ(opened.content.scene.materials[0].smooth, materials[0].smooth);
  EXPECT_EQ(opened.content.scene.materials[1].smooth, Shading::pixel);
  bytes[at + 24 + 7] = 3;
  mend(bytes);
  EXPECT_EQ(Opened(bytes).status, (Status{.error = Error::blob_damaged, .needed = at + 24 + 7}));
}

TEST(SceneBlob, OutlinesStandInBytesThatWereUnused) {
  SceneBlob content = sample();
  std::vector<Mesh> meshes(content.scene.meshes.begin(), content.scene.meshes.end());
  const Outline outlines[] = {{.colour = {1, 2, 3, 4}, .width = 0x102}, {.colour = {5, 6, 7, 8}, .width = 9}};
  const Bytes without = *to_scene_blob(content);
  EXPECT_EQ(without[122], 0);
  meshes[0].outline = 2;
  content.scene.meshes = meshes;
  content.scene.instances = content.scene.instances.first(1);  // the others have a mask
  content.scene.outlines = outlines;
  EXPECT_EQ(validate(content.scene).error, Error::outline) << "258 sixteenths";
  Bytes bytes = *to_scene_blob(content);
  EXPECT_EQ(bytes[2], without[2]) << "the version stays";
  EXPECT_EQ(bytes[122], 2);
  EXPECT_EQ(bytes[123], 0);
  const Bytes records(bytes.begin() + 192, bytes.begin() + 208);
  EXPECT_EQ(records, (Bytes{1, 2, 3, 4, 2, 1, 255, 255, 5, 6, 7, 8, 9, 0, 255, 255}));
  const std::uint32_t at = word(bytes, 12);
  EXPECT_EQ(at, 208U);
  EXPECT_EQ(bytes[at + 74], 2);
  EXPECT_EQ(bytes[at + 76 + 74], 0);
  EXPECT_EQ(Opened(bytes).status.error, Error::outline);
  bytes[196] = 0, bytes[197] = 1;
  mend(bytes);
  const Opened opened(bytes);
  ASSERT_TRUE(opened.status) << message(opened.status.error);
  EXPECT_EQ(opened.content.scene.meshes[0].outline, 2);
  EXPECT_EQ(opened.content.scene.meshes[1].outline, 0);
  ASSERT_EQ(opened.content.scene.outlines.size(), 2U);
  EXPECT_EQ(opened.content.scene.outlines[0].width, 256);
  EXPECT_EQ(opened.content.scene.outlines[1].colour, (Colour{5, 6, 7, 8}));
  EXPECT_EQ(opened.content.scene.outlines[1].hull, kOwnMesh);
  bytes[122] = 255;  // more than there are bytes
  mend(bytes);
  EXPECT_EQ(Opened(bytes).status, (Status{.error = Error::blob_damaged, .needed = 122}));
}

TEST(SceneBlob, LinesStandBehindOutlinesAndTheShadow) {
  Bytes bytes = lines_bytes();
  EXPECT_EQ(bytes[2], 3) << "the version stays";
  EXPECT_EQ(sample_bytes()[123], 0);
  EXPECT_EQ(bytes[123], 2);
  constexpr std::uint32_t kSet = 192 + 8 + 12, kNext = kSet + 64;
  EXPECT_EQ(word(bytes, 12), kNext + 64) << "then the meshes";
  EXPECT_EQ(word(bytes, kSet + 4), 3U) << "segments";
  const std::uint32_t at = word(bytes, kSet);
  EXPECT_EQ(Bytes(bytes.begin() + at, bytes.begin() + at + 12), (Bytes{0, 0, 1, 0, 1, 0, 2, 0, 3, 0, 3, 0}));
  EXPECT_EQ(word(bytes, kSet + 8), 0x10001U) << "mesh and material";
  EXPECT_EQ(word(bytes, kSet + 12), 65536U);
  EXPECT_EQ(word(bytes, kSet + 60), 64U) << "width";
  EXPECT_EQ(word(bytes, kNext) | word(bytes, kNext + 4), 0U) << "no segments";
  EXPECT_EQ(word(bytes, kNext + 8), 0x10000U);
  EXPECT_EQ(word(bytes, kNext + 12 + 44), static_cast<std::uint32_t>(-70000));

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
  EXPECT_EQ(with(123, 255), (Status{.error = Error::blob_damaged, .needed = 123})) << "more than there are bytes";
  EXPECT_EQ(with(kSet + 60, 0), (Status{.error = Error::lines, .needed = 0})) << "no width";
  EXPECT_EQ(with(kNext + 8, 2), (Status{.error = Error::lines, .needed = 1})) << "no such mesh";
  EXPECT_EQ(with(at + 10, 4), (Status{.error = Error::lines, .needed = 0})) << "no such vertex";
  EXPECT_EQ(with(123, 0).error, Error::none) << "what an older program sees";
}

TEST(SceneBlob, MoreSetsOfLinesThanAByteCountsAreRefused) {
  std::vector<LineSet> sets(256, kLines[1]);
  const std::vector<Material> plain(2);
  SceneBlob content = sample();
  content.scene.materials = plain;
  content.scene.lines = sets;
  const Result<Bytes> refused = to_scene_blob(content);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.failure().message.find("more than 255 sets of lines"), std::string::npos);
  content.scene.lines = std::span(sets).first(255);
  const Result<Bytes> written = to_scene_blob(content);
  ASSERT_TRUE(written);
  EXPECT_EQ(Opened(*written, scene_blob_memory(2, 2, 255)).content.scene.lines.size(), 255U);
}

TEST(SceneBlob, ShadowsStandInBytesThatWereUnused) {
  SceneBlob content = sample();
  std::vector<Mesh> meshes(content.scene.meshes.begin(), content.scene.meshes.end());
  const Shadow shadow{.light = 0, .log2_size = 9, .bias = 0x102, .slope_bias = 0x30405, .pool = 0x6070};
  const Bytes without = *to_scene_blob(content);
  EXPECT_EQ(without[131], 0);
  meshes[0].shadow = ShadowRole::only_casts;
  content.scene.meshes = meshes;
  content.scene.shadow = &shadow;
  Bytes bytes = *to_scene_blob(content);
  EXPECT_EQ(bytes[2], without[2]) << "the version stays";
  EXPECT_EQ(bytes[131], 1);
  EXPECT_EQ(Bytes(bytes.begin() + 192, bytes.begin() + 204), (Bytes{0, 9, 2, 1, 5, 4, 3, 0, 0x70, 0x60, 0, 0}));
  const std::uint32_t at = word(bytes, 12);
  EXPECT_EQ(at, 204U);
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
  wrong[131] = 66;  // from 2 to 65 it counts operands of products
  mend(wrong);
  EXPECT_EQ(Opened(wrong).status, (Status{.error = Error::blob_damaged, .needed = 131}));
  wrong = bytes;
  wrong[at + 75] = 4;
  mend(wrong);
  EXPECT_EQ(Opened(wrong).status, (Status{.error = Error::blob_damaged, .needed = at + 75}));
  wrong = bytes;
  wrong[192] = 77;  // no such light
  mend(wrong);
  EXPECT_EQ(Opened(wrong).status.error, Error::shadow);
}

TEST(SceneBlob, EdgesStandWhereAShadowWould) {
  const Bytes bytes = edges_bytes();
  EXPECT_EQ(bytes[2], 3) << "the version stays";
  EXPECT_EQ(bytes[131], 254) << "two sets less than 256";
  EXPECT_EQ(word(bytes, 12), 192U + 2 * 12) << "then the meshes";
  const std::uint32_t at = word(bytes, 192);
  EXPECT_EQ(word(bytes, 196), 2U);
  EXPECT_EQ(word(bytes, 200), 0U);
  EXPECT_EQ(word(bytes, 204) | word(bytes, 208), 0U);
  EXPECT_EQ(word(bytes, 212), 1U);
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
    return Opened(changed, scene_blob_memory(2, 2, 0, 190)).status;
  };
  for (const std::uint32_t offset : {0U, 128U, 130U, 0xFFFFFFFCU, static_cast<std::uint32_t>(bytes.size()) - 8}) {
    EXPECT_EQ(with(192, offset), (Status{.error = Error::blob_damaged, .needed = 192})) << offset;
  }
  for (const std::uint32_t count : {0x10000U, 0x20000000U, 0x20000002U, 0xFFFFFFFFU}) {
    EXPECT_EQ(with(196, count), (Status{.error = Error::blob_damaged, .needed = 192})) << count;
  }
  EXPECT_EQ(with(200, 2), (Status{.error = Error::edges, .needed = 0})) << "no such mesh";
  EXPECT_EQ(with(212, 0), (Status{.error = Error::edges, .needed = 1})) << "twice the same mesh";
  EXPECT_EQ(with(at + 8, 0x00040002), (Status{.error = Error::edges, .needed = 0})) << "no such vertex";
  EXPECT_EQ(with(128, 0x42000100 | bytes[128]).error, Error::blob_damaged) << "more sets than there are bytes";
}

TEST(SceneBlob, MoreSetsOfEdgesThanAByteCountsAreRefused) {
  const std::vector<Mesh> meshes(191, kMeshes[1]);
  std::vector<EdgeSet> sets(191);
  for (std::uint16_t i = 0; i < sets.size(); ++i) sets[i] = {.edges = kEdges, .mesh = i};
  SceneBlob content = sample();
  content.scene.meshes = meshes;
  content.scene.instances = content.scene.instances.first(1);
  content.scene.edges = sets;
  const Result<Bytes> refused = to_scene_blob(content);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.failure().message.find("more than 190 meshes"), std::string::npos);
  content.scene.edges = std::span(sets).first(190);
  const Result<Bytes> written = to_scene_blob(content);
  ASSERT_TRUE(written);
  EXPECT_EQ(Opened(*written, scene_blob_memory(191, 2, 0, 190)).status.error, Error::edges) << "0x302 is no vertex";
  for (EdgeSet& set : sets) set.edges = std::span(kEdges).first(2);
  EXPECT_EQ(Opened(*to_scene_blob(content), scene_blob_memory(191, 2, 0, 190)).content.scene.edges.size(), 190U);
}

// A byte says which of them there are: edges beside a shadow were left out without a word.
TEST(SceneBlob, EdgesShadowsAndProductsTogetherAreRefused) {
  constexpr CsgOperand kOperands[] = {{.instance = 0}};
  const auto refused = [&](const Shadow* shadow, std::span<const CsgOperand> csg, std::span<const EdgeSet> edges) {
    SceneBlob content = sample();
    content.scene.shadow = shadow;
    content.scene.csg = csg;
    content.scene.edges = edges;
    const Result<Bytes> written = to_scene_blob(content);
    return !written && written.failure().message.find("holds one of them") != std::string::npos;
  };
  EXPECT_TRUE(refused(&kShadow, {}, kEdgeSets));
  EXPECT_TRUE(refused(nullptr, kOperands, kEdgeSets));
  EXPECT_TRUE(refused(&kShadow, kOperands, {}));
  EXPECT_FALSE(refused(&kShadow, {}, {}));
  EXPECT_FALSE(refused(nullptr, kOperands, {}));
  EXPECT_FALSE(refused(nullptr, {}, kEdgeSets));
}

TEST(SceneBlob, ProductsStandWhereAShadowWould) {
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
  EXPECT_EQ(without[131], 0);
  content.scene.csg = operands;
  const Bytes bytes = *to_scene_blob(content);
  EXPECT_EQ(bytes[2], without[2]) << "the version stays";
  EXPECT_EQ(bytes[131], 4);
  EXPECT_EQ(bytes.size(), without.size() + 12);
  const std::size_t at = 192 + 8 * content.scene.outlines.size();
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

TEST(SceneBlob, SamplesAreAByteThatOlderBlobsLeaveZero) {
  Bytes bytes = sample_bytes();
  EXPECT_EQ(bytes[130], 0);
  EXPECT_EQ(Opened(bytes).content.view.samples, 1);
  for (int value = 0; value < 256; ++value) {
    bytes[130] = static_cast<std::uint8_t>(value);
    mend(bytes);
    const Opened opened(bytes);
    if (value <= 2 || value == 4) {
      ASSERT_TRUE(opened.status) << value;
      EXPECT_EQ(opened.content.view.samples, std::max(value, 1));
    } else {
      EXPECT_EQ(opened.status, (Status{.error = Error::blob_damaged, .needed = 130})) << value;
    }
  }
}

TEST(SceneBlob, SmallerLevelsAreAByteThatOlderBlobsDoNotHave) {
  Bytes bytes = palette_bytes();
  const std::uint32_t first = word(bytes, 28) + 11, second = first + 12;
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
