// Scene blobs: the table of sections, and which of those that a reader does not know it skips.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "blob_sample.hpp"
#include "zstrip/blob.hpp"
#include "zstrip/scene/blob_sections.hpp"

namespace zstrip::sim::test {
namespace {

constexpr std::uint32_t kTable = 16, kEntry = 12;

Status damaged(std::uint32_t at) { return {.error = Error::blob_damaged, .needed = at}; }

/// The sample's, with those of `added` at their places.
std::vector<Piece> with(std::initializer_list<Piece> added) {
  std::vector<Piece> pieces = pieces_of(sample_bytes());
  pieces.insert(pieces.end(), added);
  std::ranges::stable_sort(pieces, {}, &Piece::tag);
  return pieces;
}
std::vector<Piece> without(std::string_view tag) {
  std::vector<Piece> pieces = pieces_of(sample_bytes());
  std::erase_if(pieces, [tag](const Piece& piece) { return piece.tag == tag; });
  return pieces;
}

TEST(SceneBlobSections, AreTakenApartAndPutTogether) {
  EXPECT_EQ(blob_of(pieces_of(sample_bytes())), sample_bytes());
  EXPECT_EQ(blob_of(pieces_of(turn_bytes())), turn_bytes());
}

TEST(SceneBlobSections, TagsAreReadAsTheyStand) {
  using namespace blob_layout;
  EXPECT_EQ(tag("FOGS"), 0x464F4753U);
  EXPECT_STREQ(name_of(tag("FOGS")).data(), "FOGS");
  EXPECT_STREQ(name_of(0x01FF4D20).data(), "??M ");
  EXPECT_TRUE(must_be_known(tag("Zzzz")));
  EXPECT_FALSE(must_be_known(tag("zZZZ")));
}

/// Before, between and behind those that are known.
TEST(SceneBlobSections, UnknownOnesOfSmallLettersAreSkipped) {
  const Bytes plain = sample_bytes();
  for (const char* tag : {"aAAA", "zzzz", "treE", "tref", "x 1\n", "    "}) {
    const Bytes bytes = blob_of(with({{tag, {1, 2, 3}}}));
    EXPECT_EQ(bytes.size(), plain.size() + kEntry + 4);
    const Opened opened(bytes);
    ASSERT_TRUE(opened.status) << tag << message(opened.status.error) << opened.status.needed;
    EXPECT_EQ(opened.content.scene.meshes.size(), 2U);
    EXPECT_EQ(opened.content.scene.materials[1].depth_bias, kMaterials[1].depth_bias);
  }
  EXPECT_TRUE(Opened(blob_of(with({{"aaaa", {1}}, {"bbbb", Bytes(1000)}, {"zzzz", {2}}}))).status);
}

TEST(SceneBlobSections, UnknownOnesOfCapitalLettersAreRefusedByName) {
  for (const char* tag : {"AAAA", "FOGT", "MESI", "ZZZZ", "Zzzz", "\x01\x02\x03\x04"}) {
    const Status status = Opened(blob_of(with({{tag, {1, 2, 3, 4}}}))).status;
    EXPECT_EQ(status,
              (Status{.error = Error::blob_section, .needed = blob_layout::tag({tag[0], tag[1], tag[2], tag[3], 0})}))
        << tag;
  }
  EXPECT_STREQ(message(Error::blob_section), "the scene blob has a section that is not known here");
  // The first one is named.
  EXPECT_EQ(Opened(blob_of(with({{"ZZZZ", {1}}, {"JJJJ", {1}}}))).status.needed, blob_layout::tag("JJJJ"));
}

TEST(SceneBlobSections, AreThereOnce) {
  for (const Piece& piece : pieces_of(sample_bytes())) {
    const Bytes bytes = blob_of(with({piece}));
    const std::uint32_t second = entry_of(bytes, piece.tag) + kEntry;
    EXPECT_EQ(Opened(bytes, 10000).status, damaged(second)) << piece.tag;
  }
  const Bytes bytes = blob_of(with({{"free", {1}}, {"free", {1}}}));
  EXPECT_EQ(Opened(bytes).status, damaged(entry_of(bytes, "free") + kEntry)) << "skipped ones, too";
}

TEST(SceneBlobSections, StandInTheOrderOfTheirTags) {
  const std::vector<Piece> pieces = pieces_of(sample_bytes());
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    std::vector<Piece> swapped = pieces;
    std::swap(swapped[i - 1], swapped[i]);
    const auto second = static_cast<std::uint32_t>(kTable + i * kEntry);
    const Status status = Opened(blob_of(swapped)).status;
    // What every blob has is missed where it should be.
    const bool is_missed = status == damaged(second - kEntry) || status == damaged(second);
    EXPECT_TRUE(is_missed) << pieces[i].tag << ' ' << message(status.error) << ' ' << status.needed;
  }
  std::vector<Piece> last_first = with({{"aaaa", {1}}, {"bbbb", {1}}});
  std::swap(last_first[last_first.size() - 1], last_first[last_first.size() - 2]);
  EXPECT_EQ(Opened(blob_of(last_first)).status.error, Error::blob_damaged);
  // Behind the greatest tag that there can be.
  std::vector<Piece> beyond = with({{"\xFF\xFF\xFF\xFF", {1}}});
  EXPECT_TRUE(Opened(blob_of(beyond)).status);
  beyond.push_back({"zzzz", {1}});
  EXPECT_EQ(Opened(blob_of(beyond)).status.error, Error::blob_damaged);
}

TEST(SceneBlobSections, OverlapNowhereAndLeaveNoGap) {
  const Bytes whole = sample_bytes();
  const std::uint32_t count = word(whole, 12);
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t entry = kTable + i * kEntry;
    for (std::uint32_t j = 0; j < count; ++j) {
      if (i == j) continue;
      Bytes overlapping = whole;
      put_word(overlapping, entry + 4, word(whole, kTable + j * kEntry + 4));
      mend(overlapping);
      EXPECT_EQ(Opened(overlapping).status, damaged(entry + 4)) << i << ' ' << j;
    }
    Bytes longer = whole;
    put_word(longer, entry + 8, word(whole, entry + 8) + 4);  // into the next one
    mend(longer);
    EXPECT_EQ(Opened(longer).status.error, Error::blob_damaged);
    for (const std::uint32_t inside : {0U, 4U, 16U, kTable + count * kEntry - 4}) {  // header and table
      Bytes head = whole;
      put_word(head, entry + 4, inside);
      mend(head);
      EXPECT_EQ(Opened(head).status, damaged(entry + 4));
    }
  }
  Bytes behind = whole;
  behind.resize(whole.size() + 4);
  mend(behind);
  EXPECT_EQ(Opened(behind).status, damaged(static_cast<std::uint32_t>(whole.size())));
  Bytes uneven = whole;
  uneven.resize(whole.size() + 1);
  mend(uneven);
  EXPECT_EQ(Opened(uneven).status, damaged(4));
}

TEST(SceneBlobSections, HaveWholeRecordsAndAtLeastOne) {
  for (const Piece& piece : pieces_of(turn_bytes())) {
    for (const int change : {-1, 1}) {
      std::vector<Piece> pieces = pieces_of(turn_bytes());
      for (Piece& other : pieces) {
        if (other.tag == piece.tag) other.content.resize(other.content.size() + static_cast<std::size_t>(change));
      }
      const Bytes bytes = blob_of(pieces);
      EXPECT_EQ(Opened(bytes, 10000).status, damaged(entry_of(bytes, piece.tag) + 8)) << piece.tag;
    }
    std::vector<Piece> empty = pieces_of(turn_bytes());
    for (Piece& other : empty) {
      if (other.tag == piece.tag) other.content.clear();
    }
    const Bytes bytes = blob_of(empty);
    EXPECT_EQ(Opened(bytes, 10000).status, damaged(entry_of(bytes, piece.tag) + 8)) << piece.tag;
  }
  const Bytes skipped = blob_of(with({{"free", {}}}));
  EXPECT_EQ(Opened(skipped).status, damaged(entry_of(skipped, "free") + 8));
}

TEST(SceneBlobSections, WhatThereIsOneOfIsThereOnce) {
  for (const char* tag : {"BASE", "CAMR", "CAMT", "FOGS", "PICT", "SHAD", "TURN"}) {
    std::vector<Piece> pieces = pieces_of(turn_bytes());
    for (Piece& piece : pieces) {
      if (piece.tag == tag) piece.content.resize(2 * piece.content.size());
    }
    const Bytes bytes = blob_of(pieces);
    ASSERT_NE(entry_of(bytes, tag), 0U) << tag;
    EXPECT_EQ(Opened(bytes, 10000).status, damaged(entry_of(bytes, tag) + 8)) << tag;
  }
}

TEST(SceneBlobSections, WithoutWhatEveryBlobHasNothingOpens) {
  for (const char* tag : {"BASE", "CAMR", "PICT"}) {
    const std::uint32_t where = entry_of(sample_bytes(), tag);
    EXPECT_EQ(Opened(blob_of(without(tag))).status, damaged(where)) << tag;
  }
  // Of all others that the scene may be without there are none then.
  for (const char* tag : {"FOGS", "LDIR", "LPNT"}) EXPECT_TRUE(Opened(blob_of(without(tag))).status) << tag;
  // Nothing at all.
  EXPECT_EQ(Opened(blob_of({})).status, damaged(kTable));
}

TEST(SceneBlobSections, MoreThanThereAreBytesAreDamage) {
  const Bytes whole = sample_bytes();
  const auto room = static_cast<std::uint32_t>((whole.size() - kTable) / kEntry);
  for (const std::uint32_t count : {room + 1, 0x15555555U, 0x80000000U, 0xFFFFFFFFU}) {
    Bytes bytes = whole;
    put_word(bytes, 12, count);
    mend(bytes);
    EXPECT_EQ(Opened(bytes).status, damaged(12)) << count;
  }
  for (std::uint32_t count = 0; count <= room; ++count) {
    if (count == word(whole, 12)) continue;
    Bytes bytes = whole;
    put_word(bytes, 12, count);
    mend(bytes);
    EXPECT_FALSE(Opened(bytes).status) << count;
  }
}

}  // namespace
}  // namespace zstrip::sim::test
