// `zstrip font`: which characters are asked for, what FreeType makes of a font, and the header of it, which is compiled
// into this program.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "dejavu_font.hpp"
#include "font/characters.hpp"
#include "font/converted_font.hpp"
#include "support.hpp"
#include "zstrip/scene/valid_overlay.hpp"

namespace zstrip::sim::test {
namespace {

using Points = std::vector<std::uint32_t>;

Points points(const std::string& text) {
  const Result<Points> parsed = parse_characters(text);
  EXPECT_TRUE(parsed) << text;
  return parsed ? *parsed : Points{};
}

TEST(FontCharacters, AreRangesAndThemselves) {
  EXPECT_EQ(points("cab"), (Points{'a', 'b', 'c'}));
  EXPECT_EQ(points("a-d"), (Points{'a', 'b', 'c', 'd'}));
  EXPECT_EQ(points("0-2xa-bä"), (Points{'0', '1', '2', 'a', 'b', 'x', 0xE4}));
  EXPECT_EQ(points("a-ca-c"), (Points{'a', 'b', 'c'}));
  EXPECT_EQ(points("-a"), (Points{'-', 'a'}));
  EXPECT_EQ(points("a-"), (Points{'-', 'a'}));
  EXPECT_EQ(points("--/"), (Points{'-', '.', '/'})) << "from - to /";
  EXPECT_EQ(points("a-c-e"), (Points{'-', 'a', 'b', 'c', 'e'}));
  for (const char* text : {"", "z-a", "\xFF", "a-\xC3"}) {
    const Result<Points> parsed = parse_characters(text);
    ASSERT_FALSE(parsed) << text;
    EXPECT_EQ(parsed.failure().status, ExitStatus::usage);
    EXPECT_TRUE(parsed.failure().message.starts_with("--characters ")) << parsed.failure().message;
  }
}

FontRequest request(std::uint32_t size, std::uint8_t bits, const std::string& characters) {
  return {.file = ZSTRIP_FONT, .size = size, .bits = bits, .characters = points(characters), .replacement = {}};
}

const Glyph* glyph(const Font& font, std::uint32_t character) {
  const auto at = std::ranges::find(font.glyphs, character, &Glyph::code_point);
  return at == font.glyphs.end() ? nullptr : &*at;
}

TEST(Font, HasTheCharactersInEveryDepth) {
  for (const std::uint8_t bits : {std::uint8_t{1}, std::uint8_t{4}, std::uint8_t{8}}) {
    const Result<ConvertedFont> converted = convert_font(request(20, bits, " -~äΩ"));
    ASSERT_TRUE(converted) << converted.failure().message;
    const Font& font = converted->font;
    EXPECT_TRUE(detail::valid_font(font));
    EXPECT_TRUE(converted->missing.empty());
    EXPECT_EQ(font.glyphs.size(), 98U) << "and U+FFFD";
    EXPECT_EQ(font.coverage_bits, bits);
    EXPECT_GE(font.line_height, 20);
    ASSERT_NE(glyph(font, 'H'), nullptr);
    const Glyph& h = *glyph(font, 'H');
    EXPECT_EQ(h.height, h.top) << "stands on the baseline";
    EXPECT_NEAR(h.height, 0.729 * 20, 1) << "the height of capitals";
    EXPECT_GT(h.advance, h.width);
    EXPECT_EQ(glyph(font, ' ')->width, 0);
    EXPECT_GT(glyph(font, ' ')->advance, 3);
    // Its left stem is covered, the gap beside it is not.
    const auto at = [&](unsigned x, unsigned y) {
      const std::size_t bit = x * bits;
      const std::uint8_t byte = font.coverage[h.offset + y * ((h.width * bits + 7U) / 8) + bit / 8];
      return byte >> (8 - bits - bit % 8) & ((1U << bits) - 1);
    };
    EXPECT_GT(at(0, 0) + at(1, 0), ((1U << bits) - 1) * 3 / 4);
    EXPECT_EQ(at(h.width / 2U, 0), 0U);
  }
}

TEST(Font, CharactersThatItLacksAreSaid) {
  const Result<ConvertedFont> converted = convert_font(request(12, 4, "A\xF3\xB0\x80\x80"));
  ASSERT_TRUE(converted);
  EXPECT_EQ(converted->missing, (Points{0xF0000}));
  EXPECT_NE(glyph(converted->font, 'A'), nullptr);
}

TEST(Font, AnyBytesAreAFontOrAreRefused) {
  const Result<ConvertedFont> none = convert_font({.file = __FILE__, .characters = {'A'}, .replacement = {}});
  ASSERT_FALSE(none);
  EXPECT_NE(none.failure().message.find("is not a font that FreeType reads"), std::string::npos);
  EXPECT_FALSE(convert_font({.file = "/nowhere.ttf", .characters = {'A'}, .replacement = {}}));
}

TEST(Font, IsTheSameInTheHeader) {
  const Result<ConvertedFont> converted = convert_font(request(16, 4, "A-Za-z0-9ÄÖÜ"));
  ASSERT_TRUE(converted);
  const Font &own = converted->font, &header = test_font::kFont;
  const auto bytes = [](const auto& records) { return std::as_bytes(std::span(records)); };
  EXPECT_TRUE(std::ranges::equal(bytes(own.glyphs), bytes(header.glyphs)));
  EXPECT_TRUE(std::ranges::equal(own.coverage, header.coverage));
  EXPECT_EQ(own.coverage_bits, header.coverage_bits);
  EXPECT_EQ(own.line_height, header.line_height);
  EXPECT_EQ(own.baseline, header.baseline);
  EXPECT_EQ(own.replacement, header.replacement);
}

class FontFiles : public FolderTest {};

// A font file was read to its end, whatever its size.
TEST_F(FontFiles, OfMoreThan64MegabytesAreRefused) {
  file("large.ttf", "");
  std::filesystem::resize_file(path("large.ttf"), kMaxFontBytes + 1);
  const Result<ConvertedFont> refused =
      convert_font({.file = path("large.ttf"), .characters = {'A'}, .replacement = {}});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.failure().status, ExitStatus::input);
  EXPECT_EQ(refused.failure().message, "'" + path("large.ttf") + "' has more than 64 MB");
}

class FontCommand : public FolderTest {
 protected:
  Outcome font(std::vector<std::string> options) const {
    options.insert(options.begin(), {"font", ZSTRIP_FONT});
    return run(ZSTRIP_COMMAND, options, path(""));
  }
};

TEST_F(FontCommand, SaysWhatItWrites) {
  const Outcome outcome = font({"-o", "f.hpp", "--characters", "AB", "--size", "24"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_TRUE(outcome.out.starts_with("f.hpp: 3 characters, ")) << outcome.out;
  EXPECT_TRUE(read(path("f.hpp")).starts_with("// A font for zstrip, made of DejaVuSans.ttf, 24 pixels, 4 bits: 3 "));
  const Outcome some = font({"-o", "f.hpp", "--characters", "A\xF3\xB0\x80\x80", "--quiet"});
  EXPECT_EQ(some.status, 0);
  EXPECT_EQ(some.out, "");
  EXPECT_NE(some.err.find("does not have U+F0000; left out"), std::string::npos) << some.err;
}

TEST_F(FontCommand, RefusesWhatIsWrong) {
  const auto refused = [&](std::vector<std::string> options, const char* what) {
    options.insert(options.begin(), {"-o", "f.hpp"});
    const Outcome outcome = font(options);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_NE(outcome.err.find(what), std::string::npos) << outcome.err;
  };
  refused({"--size", "3"}, "--size 3 must be 4 to 200 pixels");
  refused({"--bits", "2"}, "--bits 2 must be 1, 4 or 8");
  refused({"--characters", "z-a"}, "--characters has a range that descends, U+007A to U+0061");
  refused({"--replacement", "ab"}, "--replacement must be one character in UTF-8");
  refused({"--replacement", "\xF3\xB0\x80\x80"}, "has no U+F0000");
  refused({"--namespace", "Font"}, "--namespace 'Font' must be");
  EXPECT_NE(font({"-o", "f.txt"}).err.find("must end in .hpp"), std::string::npos);
}

}  // namespace
}  // namespace zstrip::sim::test
