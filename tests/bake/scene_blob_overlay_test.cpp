// Scene blobs: sprites and labels, in sections of their own.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <string_view>
#include <vector>

#include "bake/scene_blob.hpp"
#include "blob_sample.hpp"
#include "zstrip/blob.hpp"
#include "zstrip/overlay.hpp"
#include "zstrip/scene/valid_overlay.hpp"

namespace zstrip::sim::test {
namespace {

constexpr std::uint16_t kImageColours[] = {0x1234, 0x5678, 0x9ABC, 0xDEF0, 0x1357, 0x2468};
constexpr std::uint8_t kCoverage[] = {0x80, 0x40, 0xF1, 0x23, 0x45, 0x67};
constexpr OverlayImage kImages[] = {{.width = 3, .height = 2, .colours = kImageColours},
                                    {.width = 1, .height = 2, .coverage = kCoverage, .coverage_bits = 1}};
constexpr Glyph kGlyphs[] = {
    {.code_point = 'A', .offset = 2, .width = 3, .height = 2, .left = -1, .top = 4, .advance = 5},
    {.code_point = 0x1F600, .offset = 0, .width = 0, .height = 0, .advance = 7}};
constexpr Font kFonts[] = {{.glyphs = kGlyphs,
                            .coverage = kCoverage,
                            .coverage_bits = 4,
                            .line_height = 6,
                            .baseline = 5,
                            .replacement = 'A'}};
constexpr Sprite kSprites[] = {{-2, 300, 1, {1, 2, 3, 4}}, {5, -6, 0}};
constexpr char kText[] = {'A', '\n', 'B'};
constexpr Label kLabels[] = {{.text = kText,
                              .x = -7,
                              .y = 8,
                              .font = 0,
                              .alignment = Alignment::right,
                              .colour = {9, 10, 11, 12},
                              .background = {13, 14, 15, 16}},
                             {.text = {}, .font = 0}};
constexpr Overlay kOverlay{kImages, kFonts, kSprites, kLabels};
const std::size_t kMemory = scene_blob_memory(2, 2, 0, 0, 2, 1, 2);

Bytes overlay_bytes(const Overlay* overlay = &kOverlay) {
  SceneBlob content = sample();
  content.scene.overlay = overlay;
  const Result<Bytes> bytes = to_scene_blob(content);
  EXPECT_TRUE(bytes);
  return bytes ? *bytes : Bytes{};
}

TEST(SceneBlobOverlay, OpensAsItWas) {
  const Bytes bytes = overlay_bytes();
  const Opened opened(bytes, kMemory);
  ASSERT_TRUE(opened.status) << message(opened.status.error);
  EXPECT_EQ(Opened(bytes, kMemory - 1).status.error, Error::blob_memory);
  ASSERT_NE(opened.content.scene.overlay, nullptr);
  const Overlay& read = *opened.content.scene.overlay;
  expect_same_bytes(read.sprites, kOverlay.sprites);
  ASSERT_EQ(read.images.size(), 2U);
  EXPECT_EQ(read.images[0].width, 3);
  EXPECT_EQ(read.images[0].height, 2);
  expect_same_bytes(read.images[0].colours, kImages[0].colours);
  EXPECT_TRUE(read.images[0].coverage.empty());
  EXPECT_TRUE(read.images[1].colours.empty());
  expect_same_bytes(read.images[1].coverage, kImages[1].coverage);
  EXPECT_EQ(read.images[1].coverage_bits, 1);
  ASSERT_EQ(read.fonts.size(), 1U);
  expect_same_bytes(read.fonts[0].glyphs, kFonts[0].glyphs);
  expect_same_bytes(read.fonts[0].coverage, kFonts[0].coverage);
  EXPECT_EQ(read.fonts[0].coverage_bits, 4);
  EXPECT_EQ(read.fonts[0].line_height, 6);
  EXPECT_EQ(read.fonts[0].baseline, 5);
  EXPECT_EQ(read.fonts[0].replacement, std::uint32_t{'A'});
  ASSERT_EQ(read.labels.size(), 2U);
  expect_same_bytes(read.labels[0].text, kLabels[0].text);
  EXPECT_EQ(read.labels[0].x, -7);
  EXPECT_EQ(read.labels[0].y, 8);
  EXPECT_EQ(read.labels[0].alignment, Alignment::right);
  EXPECT_EQ(read.labels[0].colour, (Colour{9, 10, 11, 12}));
  EXPECT_EQ(read.labels[0].background, (Colour{13, 14, 15, 16}));
  EXPECT_TRUE(read.labels[1].text.empty());
  // Coverage that images and fonts share is there once.
  EXPECT_EQ(section_bytes(bytes, "OCOV"), sizeof kCoverage);
}

TEST(SceneBlobOverlay, IsNotThereWithoutSections) {
  const Bytes without = overlay_bytes(nullptr);
  for (const char* tag : {"GLYP", "OCOL", "OCOV", "OFNT", "OIMG", "OLAB", "OSPR", "OTXT"}) {
    EXPECT_EQ(entry_of(without, tag), 0U) << tag;
  }
  const Opened opened(without);
  ASSERT_TRUE(opened.status);
  EXPECT_EQ(opened.content.scene.overlay, nullptr);
}

TEST(SceneBlobOverlay, MissingPartsAreFound) {
  for (const std::string_view tag : {"GLYP", "OCOL", "OCOV", "OFNT", "OIMG", "OTXT"}) {
    std::vector<Piece> pieces = pieces_of(overlay_bytes());
    std::erase_if(pieces, [tag](const Piece& piece) { return piece.tag == tag; });
    EXPECT_EQ(Opened(blob_of(pieces), kMemory).status.error, Error::blob_damaged) << tag;
  }
}

TEST(SceneBlobOverlay, WhatIsWrongWithARecordIsFound) {
  const auto with = [](std::string_view tag, std::size_t byte, int value) {
    Bytes bytes = overlay_bytes();
    bytes[section(bytes, tag) + byte] = static_cast<std::uint8_t>(value);
    mend(bytes);
    return Opened(bytes, kMemory).status;
  };
  const auto invalid = [](OverlayPart part, std::uint32_t index) {
    return Status{.error = Error::overlay, .needed = index, .available = static_cast<std::uint32_t>(part)};
  };
  EXPECT_EQ(with("OIMG", 16, 4), invalid(OverlayPart::image, 0)) << "too wide for its colours";
  EXPECT_EQ(with("OIMG", 24 + 20, 3), invalid(OverlayPart::image, 1)) << "bits";
  EXPECT_EQ(with("OIMG", 4, 7).error, Error::blob_damaged) << "more colours than there are";
  EXPECT_EQ(with("OFNT", 4, 3).error, Error::blob_damaged) << "more glyphs than there are";
  EXPECT_EQ(with("GLYP", 4, 6), invalid(OverlayPart::font, 0)) << "no coverage";
  EXPECT_EQ(with("OSPR", 4, 2), invalid(OverlayPart::sprite, 0));
  EXPECT_EQ(with("OLAB", 12, 1), invalid(OverlayPart::label, 0));
  EXPECT_EQ(with("OLAB", 14, 3), invalid(OverlayPart::label, 0)) << "alignment";
  EXPECT_EQ(with("OLAB", 4, 4).error, Error::blob_damaged) << "more text than there is";
}

/// Any byte of its sections, any value: refused, or drawn within what there is.
TEST(SceneBlobOverlay, AnyBytesAreSafe) {
  const Bytes good = overlay_bytes();
  std::mt19937 random(1);
  int drawn = 0;
  for (const char* tag : {"GLYP", "OCOL", "OCOV", "OFNT", "OIMG", "OLAB", "OSPR", "OTXT"}) {
    for (std::uint32_t i = 0; i < section_bytes(good, tag); ++i) {
      for (const unsigned value : {0U, 1U, 127U, 128U, 255U, static_cast<unsigned>(random() % 256)}) {
        Bytes bytes = good;
        bytes[section(good, tag) + i] = static_cast<std::uint8_t>(value);
        mend(bytes);
        const Opened opened(bytes, kMemory);
        if (!opened.status) continue;
        ++drawn;
        std::vector<std::uint16_t> pixels(40 * 30);
        draw_overlay(*opened.content.scene.overlay, {0, 0, 40, 30}, pixels.data());
      }
    }
  }
  EXPECT_GT(drawn, 300);
}

}  // namespace
}  // namespace zstrip::sim::test
