// Images, fonts, sprites and labels that a scene draws over its picture (effect::overlay). Has two fonts, and a
// function that draws an overlay without a renderer.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip/scene.hpp"
#include "zstrip/view.hpp"

namespace zstrip {

inline constexpr std::uint16_t kMaxImageSize = 4096;  ///< pixels

/// A picture with colours, with coverage, or with both. Coverage says how much of a pixel is covered, in 1, 4 or 8
/// bits. The left pixel is in the highest bits; every row starts at a byte, as in PixelFormat::mono and gray4.
struct OverlayImage {
  std::uint16_t width = 0, height = 0;       ///< pixels, 1..kMaxImageSize
  std::span<const std::uint16_t> colours{};  ///< RGB565, row by row; empty: the sprite's colour
  std::span<const std::uint8_t> coverage{};  ///< empty: every pixel is fully covered
  std::uint8_t coverage_bits = 8;            ///< 1, 4 or 8
};

/// An image whose upper left corner lies at a pixel of the picture. Pixels outside the picture are not drawn.
struct Sprite {
  std::int16_t x = 0, y = 0;          ///< pixels of the picture, to the right and down; may lie outside
  std::uint16_t image = 0;            ///< index into Overlay::images
  Colour colour{255, 255, 255, 255};  ///< colour of an image without colours; alpha of any image, 255 is opaque
};

/// The largest distances and sizes of glyphs, in pixels.
inline constexpr std::int16_t kMaxGlyphPlace = 1024;

/// The shape of a character.
struct Glyph {
  std::uint32_t code_point = 0;        ///< in Unicode
  std::uint32_t offset = 0;            ///< index of the glyph's first byte in Font::coverage
  std::uint8_t width = 0, height = 0;  ///< pixels of its coverage; 0: nothing is drawn
  std::int16_t left = 0, top = 0;      ///< from the pen to the right, from the baseline up to the first row
  std::uint16_t advance = 0;           ///< added to the pen's x, 0..kMaxGlyphPlace
};

/// The glyphs of a typeface. Rows of a glyph may reach beyond its line by at most a line's height, up or down.
struct Font {
  std::span<const Glyph> glyphs{};           ///< by ascending code point
  std::span<const std::uint8_t> coverage{};  ///< as in OverlayImage, glyph by glyph
  std::uint8_t coverage_bits = 1;            ///< 1, 4 or 8
  std::uint16_t line_height = 0;             ///< pixels, 1..kMaxGlyphPlace
  std::uint16_t baseline = 0;                ///< pixels below the line's upper border, 0..kMaxGlyphPlace
  std::uint32_t replacement = 0xFFFD;  ///< code point shown for characters without a glyph; if it has no glyph either,
                                       ///< nothing is shown
};

/// The point of a line of text that lies at Label::x.
enum class Alignment : std::uint8_t {
  left,    ///< its first pixel
  centre,  ///< its middle
  right,   ///< the pixel after its last one
};

inline constexpr std::uint16_t kMaxLabelBytes = 0xFFFF;  ///< of Label::text

/// Text in UTF-8. A byte that begins no valid character is shown as Font::replacement.
struct Label {
  std::span<const char> text{};           ///< ends at a byte of 0, or with the span; '\n' begins the next line
  std::int16_t x = 0, y = 0;              ///< pixel of the picture; y: the first line's upper border
  std::uint16_t font = 0;                 ///< index into Overlay::fonts
  Alignment alignment = Alignment::left;  ///< of each line
  Colour colour{255, 255, 255, 255};      ///< alpha 255 is opaque
  Colour background{0, 0, 0, 0};          ///< behind each line, as wide as its text; alpha 0: no background
};

/// Drawn in this order, sprites before labels, into the finished pixels (docs/conventions.md, "Overlay"). Sprites,
/// labels and text may change between frames: begin_frame reads them again. They must not change from begin_frame to
/// the last strip.
struct Overlay {
  std::span<const OverlayImage> images{};  ///< tables in flash or in RAM
  std::span<const Font> fonts{};           ///< kSmallFont, kLargeFont, or made by `zstrip font`
  std::span<const Sprite> sprites{};       ///< later ones are drawn over earlier ones
  std::span<const Label> labels{};         ///< later ones are drawn over earlier ones
};

// Both fonts have the ASCII characters, in cells of 6x8 pixels, and smoothed in 12x16. An unused font takes no flash;
// the small one takes 2.3 KB, the large one 7 KB.

namespace detail {

/// U+0020 to U+007E, and a box for U+FFFD.
inline constexpr std::size_t kFontGlyphs = 96;
inline constexpr std::size_t kSmallFontBytes = kFontGlyphs * 8;
inline constexpr std::size_t kLargeFontBytes = 5292;
extern const std::array<Glyph, kFontGlyphs> kSmallFontGlyphs, kLargeFontGlyphs;
extern const std::array<std::uint8_t, kSmallFontBytes> kSmallFontCoverage;
extern const std::array<std::uint8_t, kLargeFontBytes> kLargeFontCoverage;

}  // namespace detail

/// Advances 6 pixels a letter, 9 a line.
inline constexpr Font kSmallFont{.glyphs = detail::kSmallFontGlyphs,
                                 .coverage = detail::kSmallFontCoverage,
                                 .coverage_bits = 1,
                                 .line_height = 9,
                                 .baseline = 7};
/// Advances 12 pixels a letter, 18 a line.
inline constexpr Font kLargeFont{.glyphs = detail::kLargeFontGlyphs,
                                 .coverage = detail::kLargeFontCoverage,
                                 .coverage_bits = 4,
                                 .line_height = 18,
                                 .baseline = 14};

/// Draws the overlay over the RGB565 pixels of a rectangle of the picture, which have no gaps. Renderers with
/// effect::overlay do this by themselves; call this for pixels of draw_over, or of another source. `overlay` must have
/// passed validate().
void draw_overlay(const Overlay& overlay, const Rect& area, std::uint16_t* pixels);

}  // namespace zstrip
