// Scene blobs: no bytes whatever do harm.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <tuple>
#include <vector>

#include "../oracle/draw.hpp"
#include "blob_sample.hpp"
#include "zstrip/scene/scene_blob.hpp"

namespace zstrip::sim::test {
namespace {

TEST(SceneBlob, PalettesNeedAllTheirWords) {
  const Bytes whole = palette_bytes();
  const std::uint32_t textures = word(whole, 28);
  for (std::uint32_t i = 0; i < 2; ++i) {
    for (const std::uint32_t words : {0U, 1U, 15U, i == 0 ? 16U : 258U}) {
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
TEST(SceneBlob, TruncatedAtEveryLengthWithLines) { expect_every_part_refused(lines_bytes()); }
TEST(SceneBlob, TruncatedAtEveryLengthWithEdges) { expect_every_part_refused(edges_bytes()); }
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
  AnyRenderer renderer(effects);
  renderer.set_visibility({.tree = &content.tree});
  const picture::Picture drawn = picture::draw(renderer, content.scene, content.camera, kView, planned.plan);
  EXPECT_TRUE(drawn.status || drawn.pixels.empty()) << "begun, but not drawn";
}

/// Who writes a wrong value also writes its checksum.
TEST(SceneBlob, EveryByteChangedUnderARightChecksum) {
  for (const Bytes& whole :
       {sample_bytes(), tree_bytes(), palette_bytes(), lines_bytes(), turn_bytes(), edges_bytes()}) {
    const bool has_tree = word(whole, 184) != 0;
    std::size_t refused = 0, drawn = 0;
    for (std::size_t at = 12; at < whole.size(); ++at) {
      for (const int value : {0x00, 0x01, 0x02, 0x7F, 0x80, 0xFF}) {
        Bytes changed = whole;
        changed[at] = static_cast<std::uint8_t>(value);
        mend(changed);
        const Opened opened(changed, scene_blob_memory(300, 300, 255, 190));
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

TEST(SceneBlob, SegmentsBeyondTheEnd) {
  const Bytes whole = lines_bytes();
  constexpr std::uint32_t kSet = 192 + 8 + 12;  // behind the header, the outline and the shadow
  ASSERT_EQ(word(whole, kSet + 4), 3U);
  for (const std::uint32_t value : {0U, 128U, 130U, 0xFFFFFFFCU, static_cast<std::uint32_t>(whole.size()) - 8}) {
    Bytes changed = whole;
    put_word(changed, kSet, value);
    mend(changed);
    const Opened opened(changed, scene_blob_memory(2, 2, 2));
    EXPECT_EQ(opened.status, (Status{.error = Error::blob_damaged, .needed = kSet})) << value;
  }
  for (const std::uint32_t count : {0x10000U, 0x40000000U, 0x40000003U, 0xFFFFFFFFU}) {
    Bytes changed = whole;
    put_word(changed, kSet + 4, count);
    mend(changed);
    const Opened opened(changed, scene_blob_memory(2, 2, 2));
    EXPECT_EQ(opened.status, (Status{.error = Error::blob_damaged, .needed = kSet})) << count;
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
  for (const std::size_t flag : {material + 6, material + 8, material + 10, std::size_t{120}, std::size_t{121}}) {
    EXPECT_EQ(error_with(flag, 2), (Status{.error = Error::blob_damaged, .needed = static_cast<std::uint32_t>(flag)}));
  }
  EXPECT_EQ(error_with(material + 7, 3).error, Error::blob_damaged);  // shading
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
