// Scene blobs: no bytes whatever do harm.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <memory>
#include <tuple>
#include <vector>

#include "../oracle/draw.hpp"
#include "blob_sample.hpp"
#include "zstrip/blob.hpp"

namespace zstrip::sim::test {
namespace {

TEST(SceneBlob, PalettesNeedAllTheirWords) {
  const Bytes whole = palette_bytes();
  const std::uint32_t textures = section(whole, "TEXT");
  for (std::uint32_t i = 0; i < 2; ++i) {
    for (const std::uint32_t words : {0U, 1U, 15U, i == 0 ? 16U : 258U}) {
      Bytes fewer = whole;
      put_word(fewer, textures + 12 * i + 4, words);
      mend(fewer);
      EXPECT_EQ(Opened(fewer).status, (Status{.error = Error::texture, .needed = i})) << words;
    }
    Bytes larger = whole;
    larger[textures + 12 * i + 8] = 11;  // 2048 texels across
    mend(larger);
    EXPECT_EQ(Opened(larger).status, (Status{.error = Error::texture, .needed = i}));
  }
}

TEST(SceneBlob, ATreeThatIsNoneIsDamaged) {
  const Bytes whole = tree_bytes();
  const std::uint32_t nodes = section(whole, "tree");
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
  std::vector<Piece> several = pieces_of(sample_bytes());  // of a scene of three instances
  several.push_back({"tree", Bytes(32)});
  const Bytes of_several = blob_of(several);
  EXPECT_EQ(Opened(of_several).status, (Status{.error = Error::blob_damaged, .needed = section(of_several, "tree")}));
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
TEST(SceneBlob, TruncatedAtEveryLengthWithLines) { expect_every_part_refused(lines_bytes()); }
TEST(SceneBlob, TruncatedAtEveryLengthWithEdges) { expect_every_part_refused(edges_bytes()); }
TEST(SceneBlob, TruncatedAtEveryLengthWithSkins) { expect_every_part_refused(skin_bytes()); }
TEST(SceneBlob, TruncatedAtEveryLengthWithMorphTargets) { expect_every_part_refused(morph_bytes()); }
TEST(SceneBlob, TruncatedAtEveryLengthWithATurn) { expect_every_part_refused(turn_bytes()); }
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
      const bool is_other_version = at == 2 && flipped[at] != kSceneBlobVersion;
      ASSERT_EQ(status.error, is_other_version ? Error::blob_version : Error::blob_damaged) << at;
    }
  }
}

/// Draws whatever has opened: it has passed the same checks as any scene.
void draw(const SceneBlob& content, Effects method = {}) {
  constexpr View kView{48, 32, PixelFormat::rgb565};
  const Effects effects = effects_of(content.scene, content.camera) | method;
  const PlanResult planned = plan(count(content.scene), kView, effects, {.strip_rows = 16});
  if (!planned.status) return;
  AnyRenderer renderer(effects);
  renderer.set_visibility({.tree = &content.tree});
  const picture::Picture drawn = picture::draw(renderer, content.scene, content.camera, kView, planned.plan);
  EXPECT_TRUE(drawn.status || drawn.pixels.empty()) << "begun, but not drawn";
}

/// Safe at any time, through a fade too; a pose may be refused.
void pose_at_many_times(const SceneBlob& content) {
  PlayedClips played;
  if (content.clips.size() > 1) played.play(1, 500);
  std::vector<Instance> instances(content.scene.instances.size());
  for (int i = 0; i < 3; ++i) {
    (void)pose_clips(content.clips, played.all(), content.moved);
    (void)pose_clips(content.clips, played.all(), content.morphs);
    if (content.clips.empty()) return;
    pose_clips(content.clips, played.all(), content.scene.instances, instances);
    played.advance(200, content.clips);
  }
}

/// Who writes a wrong value also writes its checksum.
// Each byte gets two of the values; with ZSTRIP_LONG all six.
TEST(SceneBlob, EveryByteChangedUnderARightChecksum) {
  const std::size_t step = std::getenv("ZSTRIP_LONG") == nullptr ? 3 : 1;
  constexpr int kValues[] = {0x00, 0x01, 0x02, 0x7F, 0x80, 0xFF};
  for (const Bytes& whole : {sample_bytes(), tree_bytes(), palette_bytes(), lines_bytes(), turn_bytes(), edges_bytes(),
                             skin_bytes(), morph_bytes()}) {
    const bool has_tree = entry_of(whole, "tree") != 0;
    std::size_t refused = 0, drawn = 0;
    for (std::size_t at = 12; at < whole.size(); ++at) {
      for (std::size_t value = at % step; value < std::size(kValues); value += step) {
        Bytes changed = whole;
        changed[at] = static_cast<std::uint8_t>(kValues[value]);
        mend(changed);
        const Opened opened(changed, scene_blob_memory(300, 300, 255, 190) + 4096);
        if (!opened.status) {
          ++refused;
          continue;
        }
        ++drawn;
        pose_at_many_times(opened.content);
        draw(opened.content, has_tree ? method::painter | method::bsp : Effects{});
      }
    }
    EXPECT_GT(refused, 300U);
    EXPECT_GT(drawn, 300U);
  }
}

TEST(SceneBlob, SectionsBeyondTheEnd) {
  for (const Bytes& whole : {sample_bytes(), tree_bytes(), lines_bytes(), edges_bytes(), skin_bytes(), morph_bytes()}) {
    const auto with = [&whole](std::size_t at, std::uint32_t value) {
      Bytes changed = whole;
      put_word(changed, at, value);
      mend(changed);
      return Opened(changed, kMorphMemory + scene_blob_memory(0, 0, 2, 2)).status;
    };
    for (std::uint32_t entry = 16; entry < 16 + 12 * word(whole, 12); entry += 12) {
      const std::uint32_t offset = word(whole, entry + 4), bytes = word(whole, entry + 8);
      for (const std::uint32_t value :
           {0xFFFFFFFFU, 0xFFFFFFFCU, 0x80000000U, 0x7FFFFFFCU, static_cast<std::uint32_t>(whole.size()),
            static_cast<std::uint32_t>(whole.size()) - 4, offset - 4, offset + 1, offset + 2, offset + 4, 0U}) {
        EXPECT_EQ(with(entry + 4, value), (Status{.error = Error::blob_damaged, .needed = entry + 4})) << value;
      }
      for (const std::uint32_t value :
           {0xFFFFFFFFU, 0xFFFFFFFCU, 0x80000000U, static_cast<std::uint32_t>(whole.size()) - offset + 1,
            static_cast<std::uint32_t>(whole.size()), 0U}) {
        EXPECT_EQ(with(entry + 8, value), (Status{.error = Error::blob_damaged, .needed = entry + 8})) << value;
      }
      EXPECT_EQ(with(entry + 8, bytes + 4).error, Error::blob_damaged);
    }
  }
}

/// In records that name some of the records of another section.
TEST(SceneBlob, RecordsThatAreNotThere) {
  struct Case {
    Bytes bytes;
    const char* section;
    std::uint32_t at;   ///< in the section
    const char* named;  ///< section of the records
    std::uint32_t record;
  };
  const Case cases[] = {{sample_bytes(), "MESH", 0, "POSI", 6},  {sample_bytes(), "MESH", 8, "NORM", 4},
                        {sample_bytes(), "MESH", 16, "COLR", 4}, {sample_bytes(), "MESH", 24, "TEXC", 4},
                        {sample_bytes(), "MESH", 32, "TRIA", 6}, {sample_bytes(), "MESH", 40, "MLET", 20},
                        {sample_bytes(), "TEXT", 12, "TEXL", 2}, {lines_bytes(), "LSET", 0, "SEGM", 4},
                        {edges_bytes(), "ESET", 0, "EDGE", 8},   {skin_bytes(), "SKIN", 0, "VJOI", 8},
                        {morph_bytes(), "MTGT", 8, "MOFF", 6},   {morph_bytes(), "MTGT", 16, "MOFN", 3}};
  for (const Case& one : cases) {
    const std::uint32_t at = section(one.bytes, one.section) + one.at;
    const std::uint32_t all = section_bytes(one.bytes, one.named) / one.record;
    ASSERT_GT(all, 0U) << one.named;
    const auto with = [&](std::uint32_t first, std::uint32_t count) {
      Bytes changed = one.bytes;
      put_word(changed, at, first);
      put_word(changed, at + 4, count);
      mend(changed);
      return Opened(changed, kMorphMemory + scene_blob_memory(0, 0, 2, 2)).status;
    };
    for (const auto& [first, count] : {std::pair{0U, all + 1},
                                       {1U, all},
                                       {all, 1U},
                                       {all + 1, 0U},
                                       {0xFFFFFFFFU, 1U},
                                       {0xFFFFFFFFU, 0xFFFFFFFFU},
                                       {1U, 0xFFFFFFFFU},
                                       {0U, 0x80000000U},
                                       {0x80000000U, 0x80000000U}}) {
      EXPECT_EQ(with(first, count), (Status{.error = Error::blob_damaged, .needed = at})) << one.named << first;
    }
    EXPECT_NE(with(all, 0).error, Error::blob_damaged) << "none of them";
  }
}

TEST(SceneBlob, ValuesThatAreNone) {
  const Bytes whole = sample_bytes();
  const std::size_t material = section(whole, "MATL"), camera = section(whole, "CAMR"),
                    picture = section(whole, "PICT");
  const auto error_with = [&whole](std::size_t at, std::uint8_t value) {
    Bytes changed = whole;
    changed[at] = value;
    mend(changed);
    return Opened(changed).status;
  };
  const auto damaged = [](std::size_t at) {
    return Status{.error = Error::blob_damaged, .needed = static_cast<std::uint32_t>(at)};
  };
  for (const std::size_t flag : {material + 6, material + 8, material + 10, camera + 60, camera + 61, picture + 5}) {
    EXPECT_EQ(error_with(flag, 2), damaged(flag));
  }
  EXPECT_EQ(error_with(material + 7, 3), damaged(material + 7));  // shading
  EXPECT_EQ(error_with(material + 9, 8), damaged(material + 9));  // depth test
  EXPECT_EQ(error_with(picture + 4, static_cast<std::uint8_t>(kLastPixelFormat) + 1), damaged(picture + 4));
  EXPECT_EQ(error_with(picture + 1, 17), damaged(picture));  // 4416 pixels wide
  for (const int samples : {0, 3, 5, 255}) {
    EXPECT_EQ(error_with(picture + 6, static_cast<std::uint8_t>(samples)), damaged(picture + 6));
  }
  EXPECT_EQ(error_with(picture + 7, 8), damaged(picture + 7));
  EXPECT_EQ(error_with(3, 'd').error, Error::blob_damaged);
  EXPECT_EQ(error_with(camera + 51, 0x80).error, Error::camera);  // negative focal length
}

/// All have these three bytes in one place: they are to be baked again, and never opened by chance.
TEST(SceneBlob, OtherVersionsAreRefused) {
  for (int version = 0; version < 256; ++version) {
    if (version == kSceneBlobVersion || version == kFirstSceneBlobVersion) continue;
    for (const bool mended : {false, true}) {
      Bytes other = sample_bytes();
      other[2] = static_cast<std::uint8_t>(version);
      if (mended) mend(other);
      EXPECT_EQ(Opened(other).status,
                (Status{.error = Error::blob_version, .needed = static_cast<std::uint32_t>(version), .available = 6}));
      other.resize(4);
      EXPECT_EQ(Opened(other).status.error, Error::blob_version);
    }
  }
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
