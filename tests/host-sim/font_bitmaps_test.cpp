// `zstrip font` with a font that brings bitmaps beside its outlines, which the test adds to one that has none.
#include <ft2build.h>
#include <gtest/gtest.h>
#include FT_FREETYPE_H

#include <map>
#include <span>
#include <string>
#include <vector>

#include "font/converted_font.hpp"
#include "import/read_file.hpp"
#include "support.hpp"

namespace zstrip::sim::test {
namespace {

std::uint32_t number(std::span<const std::uint8_t> bytes, std::size_t at, std::size_t size) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < size; ++i) value = value << 8 | bytes[at + i];
  return value;
}
void append(std::vector<std::uint8_t>& bytes, std::size_t size, std::uint32_t value) {
  for (std::size_t i = size; i-- > 0;) bytes.push_back(static_cast<std::uint8_t>(value >> 8 * i));
}

/// DejaVu Sans with a bitmap of 16 x 16 pixels of one bit for the glyphs 3 to 200 at 16 pixels: tables EBLC and EBDT of
/// OpenType, images of format 1.
std::vector<std::uint8_t> with_bitmaps() {
  constexpr std::uint32_t kFirst = 3, kLast = 200, kImageBytes = 5 + 16 * 2;
  const std::vector<std::uint8_t> font = *read_file(ZSTRIP_FONT);
  std::map<std::uint32_t, std::vector<std::uint8_t>> tables;
  for (std::uint32_t i = 0; i < number(font, 4, 2); ++i) {
    const std::size_t entry = 12 + 16 * i;
    const auto first = font.begin() + number(font, entry + 8, 4);
    tables[number(font, entry, 4)].assign(first, first + number(font, entry + 12, 4));
  }
  std::vector<std::uint8_t>& images = tables[0x45424454];  // EBDT
  append(images, 4, 0x00020000);
  for (std::uint32_t glyph = kFirst; glyph <= kLast; ++glyph) {
    for (const std::uint32_t metric : {16U, 16U, 0U, 12U, 17U}) append(images, 1, metric);
    for (int row = 0; row < 16; ++row) append(images, 2, 0xFF81);
  }
  std::vector<std::uint8_t>& places = tables[0x45424C43];  // EBLC
  append(places, 4, 0x00020000);
  append(places, 4, 1);  // strikes
  const std::uint32_t subtable_bytes = 8 + 4 * (kLast - kFirst + 2);
  for (const std::uint32_t value : {56U, 8 + subtable_bytes, 1U, 0U}) append(places, 4, value);
  for (int line = 0; line < 2; ++line) {  // horizontal, vertical: ascender, descender, widest
    for (const std::uint32_t metric : {12U, 252U, 16U, 0U, 0U, 0U, 0U, 0U, 12U, 252U, 0U, 0U})
      append(places, 1, metric);
  }
  for (const std::uint32_t glyph : {kFirst, kLast}) append(places, 2, glyph);
  for (const std::uint32_t value : {16U, 16U, 1U, 1U}) append(places, 1, value);  // pixels an em, bits, flags
  for (const std::uint32_t glyph : {kFirst, kLast}) append(places, 2, glyph);
  for (const std::uint32_t value : {8U, 0x00010001U, 4U}) append(places, 4, value);  // its subtable, formats, images
  for (std::uint32_t glyph = kFirst; glyph <= kLast + 1; ++glyph) append(places, 4, (glyph - kFirst) * kImageBytes);

  std::vector<std::uint8_t> whole(font.begin(), font.begin() + 4), content;
  append(whole, 2, static_cast<std::uint32_t>(tables.size()));
  append(whole, 6, 0);  // what helps to search
  for (auto& [tag, table] : tables) {
    append(whole, 4, tag);
    append(whole, 4, 0);  // no checksum is looked at
    append(whole, 4, static_cast<std::uint32_t>(12 + 16 * tables.size() + content.size()));
    append(whole, 4, static_cast<std::uint32_t>(table.size()));
    table.resize((table.size() + 3) / 4 * 4);
    content.insert(content.end(), table.begin(), table.end());
  }
  whole.insert(whole.end(), content.begin(), content.end());
  return whole;
}

/// Bits a pixel of what FreeType loads for an A at 16 pixels; 0: an outline.
int bitmap_bits(const std::string& path) {
  FT_Library library = nullptr;
  FT_Face face = nullptr;
  if (FT_Init_FreeType(&library) != 0 || FT_New_Face(library, path.c_str(), 0, &face) != 0) return -1;
  FT_Set_Pixel_Sizes(face, 0, 16);
  FT_Load_Char(face, 'A', FT_LOAD_DEFAULT);
  const bool is_bitmap = face->glyph->format == FT_GLYPH_FORMAT_BITMAP;
  const int bits = !is_bitmap ? 0 : face->glyph->bitmap.pixel_mode == FT_PIXEL_MODE_MONO ? 1 : 8;
  FT_Done_Face(face);
  FT_Done_FreeType(library);
  return bits;
}

class FontWithBitmaps : public FolderTest {};

TEST_F(FontWithBitmaps, TheyAreNotReadAsIfTheyWereDrawn) {
  const std::vector<std::uint8_t> whole = with_bitmaps();
  const std::string made = file("bitmaps.ttf", {whole.begin(), whole.end()});
  ASSERT_EQ(bitmap_bits(made), 1) << "FreeType takes the bitmap where it is let";
  for (const std::uint8_t bits : {std::uint8_t{1}, std::uint8_t{4}, std::uint8_t{8}}) {
    FontRequest request{.file = ZSTRIP_FONT, .size = 16, .bits = bits, .characters = {'A', 'B'}, .replacement = {}};
    const Result<ConvertedFont> outlines = convert_font(request);
    request.file = made;
    const Result<ConvertedFont> converted = convert_font(request);
    ASSERT_TRUE(outlines && converted);
    EXPECT_EQ(converted->coverage, outlines->coverage) << int{bits};
  }
}

}  // namespace
}  // namespace zstrip::sim::test
