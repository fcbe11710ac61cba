// Converts outlines to glyphs; see converted_font.hpp.
#include "font/converted_font.hpp"

#include <fmt/format.h>
#include <ft2build.h>
#include FT_FREETYPE_H

#include <algorithm>
#include <memory>
#include <type_traits>

#include "font/characters.hpp"
#include "import/read_file.hpp"
#include "zstrip/scene/valid_overlay.hpp"

namespace zstrip::sim {
namespace {

struct EndFreeType {
  void operator()(FT_Library library) const { FT_Done_FreeType(library); }
  void operator()(FT_Face face) const { FT_Done_Face(face); }
};
template <class Handle>
using Owned = std::unique_ptr<std::remove_pointer_t<Handle>, EndFreeType>;

/// Rounds 26.6 up to whole pixels.
long rounded_up(FT_Pos value) { return (value + 63) >> 6; }

class Converter {
 public:
  explicit Converter(const FontRequest& request) : request_(request) {}

  Result<ConvertedFont> run() {
    if (const Result<Done> opened = open(); !opened) return opened.failure();
    Font& font = converted_.font;
    const FT_Size_Metrics& metrics = face_->size->metrics;
    const long above = rounded_up(metrics.ascender), below = rounded_up(-metrics.descender);
    font.coverage_bits = request_.bits;
    font.baseline = static_cast<std::uint16_t>(std::clamp(above, 0L, long{kMaxGlyphPlace}));
    font.line_height = static_cast<std::uint16_t>(
        std::clamp(std::max(above + below, rounded_up(metrics.height)), 1L, long{kMaxGlyphPlace}));
    std::vector<std::uint32_t> characters = request_.characters;
    const bool has_own = FT_Get_Char_Index(face_.get(), font.replacement) != 0;
    if (request_.replacement) font.replacement = *request_.replacement;
    if (request_.replacement || has_own) {
      const auto at = std::ranges::lower_bound(characters, font.replacement);
      if (at == characters.end() || *at != font.replacement) characters.insert(at, font.replacement);
    }
    for (const std::uint32_t character : characters) {
      if (const Result<Done> added = add(character); !added) return added.failure();
    }
    if (converted_.glyphs.empty()) return wrong("has none of these characters");
    font.glyphs = converted_.glyphs;
    font.coverage = converted_.coverage;
    if (!detail::valid_font(font)) return wrong("has characters that reach too far beyond their line");
    return std::move(converted_);
  }

 private:
  Failure wrong(const std::string& what) const {
    return {ExitStatus::input, fmt::format("'{}' {}", request_.file.string(), what)};
  }

  Result<Done> open() {
    Result<std::vector<std::uint8_t>> bytes = read_file(request_.file, kMaxFontBytes);
    if (!bytes) return wrong(bytes.failure().message);
    bytes_ = std::move(*bytes);
    FT_Library library = nullptr;
    if (FT_Init_FreeType(&library) != 0) return Failure{ExitStatus::internal, "FreeType does not start"};
    library_.reset(library);
    FT_Face face = nullptr;
    if (FT_New_Memory_Face(library, bytes_.data(), static_cast<FT_Long>(bytes_.size()), 0, &face) != 0) {
      return wrong("is not a font that FreeType reads; give a TrueType or OpenType font");
    }
    face_.reset(face);
    if (!FT_IS_SCALABLE(face)) return wrong("has no outlines that could be drawn at any size");
    if (FT_Select_Charmap(face, FT_ENCODING_UNICODE) != 0) return wrong("does not say which characters it has");
    if (FT_Set_Pixel_Sizes(face, 0, request_.size) != 0) return wrong("cannot be drawn at this size");
    return Done{};
  }

  Result<Done> add(std::uint32_t character) {
    const FT_UInt index = FT_Get_Char_Index(face_.get(), character);
    if (index == 0) {
      converted_.missing.push_back(character);
      return Done{};
    }
    const bool mono = request_.bits == 1;
    // Only outlines are used: bitmaps in the font may have another number of bits a pixel.
    const int load = FT_LOAD_NO_BITMAP | (mono ? FT_LOAD_TARGET_MONO : FT_LOAD_TARGET_NORMAL);
    if (FT_Load_Glyph(face_.get(), index, load) != 0 ||
        FT_Render_Glyph(face_->glyph, mono ? FT_RENDER_MODE_MONO : FT_RENDER_MODE_NORMAL) != 0) {
      return wrong(fmt::format("is damaged: {} cannot be drawn", name_of_character(character)));
    }
    const FT_GlyphSlot slot = face_->glyph;
    const FT_Bitmap& bitmap = slot->bitmap;
    if (bitmap.rows > 0 && bitmap.pixel_mode != (mono ? FT_PIXEL_MODE_MONO : FT_PIXEL_MODE_GRAY)) {
      return wrong(fmt::format("has no outline for {}", name_of_character(character)));
    }
    const long advance = (slot->advance.x + 32) >> 6;
    const auto within = [](long place) { return place >= -kMaxGlyphPlace && place <= kMaxGlyphPlace; };
    if (bitmap.width > 255 || bitmap.rows > 255 || !within(slot->bitmap_left) || !within(slot->bitmap_top) ||
        advance < 0 || advance > kMaxGlyphPlace) {
      return wrong(fmt::format("has {} larger than 255 pixels at this size", name_of_character(character)));
    }
    converted_.glyphs.push_back({.code_point = character,
                                 .offset = static_cast<std::uint32_t>(converted_.coverage.size()),
                                 .width = static_cast<std::uint8_t>(bitmap.width),
                                 .height = static_cast<std::uint8_t>(bitmap.rows),
                                 .left = static_cast<std::int16_t>(slot->bitmap_left),
                                 .top = static_cast<std::int16_t>(slot->bitmap_top),
                                 .advance = static_cast<std::uint16_t>(advance)});
    const std::size_t first = converted_.coverage.size();
    for (unsigned y = 0; y < bitmap.rows; ++y) append_row(bitmap, y);
    const auto own = converted_.coverage.begin() + static_cast<std::ptrdiff_t>(first);
    if (std::all_of(own, converted_.coverage.end(), [](std::uint8_t byte) { return byte == 0; })) {
      // FreeType gives a space one pixel.
      Glyph& glyph = converted_.glyphs.back();
      glyph.width = glyph.height = 0;
      glyph.left = glyph.top = 0;
      converted_.coverage.erase(own, converted_.coverage.end());
    }
    return Done{};
  }

  void append_row(const FT_Bitmap& bitmap, unsigned y) {
    const std::uint8_t* const row = bitmap.buffer + static_cast<std::ptrdiff_t>(y) * bitmap.pitch;
    const std::size_t first = converted_.coverage.size();
    const unsigned bits = request_.bits;
    converted_.coverage.resize(first + detail::coverage_row_bytes(bitmap.width, bits));
    for (unsigned x = 0; x < bitmap.width; ++x) {
      const unsigned full = bits == 1 ? (row[x / 8] >> (7 - x % 8) & 1U) * 255U : row[x];
      const unsigned level = (full * ((1U << bits) - 1) + 127) / 255, at = x * bits;
      std::uint8_t& byte = converted_.coverage[first + at / 8];
      byte = static_cast<std::uint8_t>(byte | level << (8 - bits - at % 8));
    }
  }

  const FontRequest& request_;
  std::vector<std::uint8_t> bytes_;  // must outlive the face
  Owned<FT_Library> library_;
  Owned<FT_Face> face_;
  ConvertedFont converted_;
};

}  // namespace

Result<ConvertedFont> convert_font(const FontRequest& request) { return Converter(request).run(); }

}  // namespace zstrip::sim
