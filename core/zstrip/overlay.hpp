// What a scene draws over its picture: images, fonts, sprites and labels (effect::overlay). Two fonts, and how to draw
// an overlay without a renderer.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip/scene.hpp"
#include "zstrip/view.hpp"

namespace zstrip {

inline constexpr std::uint16_t kMaxImageSize = 4096;  ///< pixels

/// A picture with colours, with coverage, or with both. Coverage is how much of a pixel is covered: of 1, 4 or 8 bits,
/// the left pixel in the highest ones; every row starts at a byte, as in PixelFormat::mono and gray4.
struct OverlayImage {
  std::uint16_t width = 0, height = 0;       ///< pixels, 1..kMaxImageSize
  std::span<const std::uint16_t> colours{};  ///< RGB565, row by row; empty: of the sprite's colour
  std::span<const std::uint8_t> coverage{};  ///< empty: all of it is covered
  std::uint8_t coverage_bits = 8;            ///< 1, 4 or 8
};

/// An image, with its upper left corner at a pixel of the picture. What lies outside the picture is not drawn.
struct Sprite {
  std::int16_t x = 0, y = 0;          ///< pixels of the picture, to the right and down; may lie outside
  std::uint16_t image = 0;            ///< index into Overlay::images
  Colour colour{255, 255, 255, 255};  ///< of an image without colours; alpha: of any image, 255 is opaque
};

/// The largest distances and sizes of glyphs, in pixels.
inline constexpr std::int16_t kMaxGlyphPlace = 1024;

/// The shape of a character.
struct Glyph {
  std::uint32_t code_point = 0;        ///< of Unicode
  std::uint32_t offset = 0;            ///< of its first byte in Font::coverage
  std::uint8_t width = 0, height = 0;  ///< pixels of its coverage; 0: nothing is drawn
  std::int16_t left = 0, top = 0;      ///< from the pen to the right, from the baseline up to the first row
  std::uint16_t advance = 0;           ///< of the pen, 0..kMaxGlyphPlace
};

/// Rows of a glyph may reach beyond its line by a line's height at most, up or down.
struct Font {
  std::span<const Glyph> glyphs{};           ///< by ascending code point
  std::span<const std::uint8_t> coverage{};  ///< as an image's, glyph by glyph
  std::uint8_t coverage_bits = 1;            ///< 1, 4 or 8
  std::uint16_t line_height = 0;             ///< pixels, 1..kMaxGlyphPlace
  std::uint16_t baseline = 0;                ///< below the line's upper border, 0..kMaxGlyphPlace
  std::uint32_t replacement = 0xFFFD;  ///< code point of what is shown for others; nothing is if it is missing, too
};

/// What of a line of text lies at Label::x.
enum class Alignment : std::uint8_t {
  left,    ///< its first pixel
  centre,  ///< its middle
  right,   ///< the pixel behind its last one
};

inline constexpr std::uint16_t kMaxLabelBytes = 0xFFFF;  ///< of Label::text

/// Text in UTF-8. A byte that begins no valid character is shown as Font::replacement.
struct Label {
  std::span<const char> text{};           ///< ends at a byte of 0, or with the span; '\n' begins the next line
  std::int16_t x = 0, y = 0;              ///< pixel of the picture; y: the first line's upper border
  std::uint16_t font = 0;                 ///< index into Overlay::fonts
  Alignment alignment = Alignment::left;  ///< of each line
  Colour colour{255, 255, 255, 255};      ///< alpha: 255 is opaque
  Colour background{0, 0, 0, 0};          ///< of each line, as wide as its text, below the text; alpha 0: none
};

/// Drawn in this order, sprites before labels, into the finished pixels (docs/conventions.md, "Overlay"). Sprites and
/// labels may change between frames, and text, too: begin_frame looks at them again. From there to the last strip
/// nothing may change.
struct Overlay {
  std::span<const OverlayImage> images{};  ///< in flash or in RAM, as the rest
  std::span<const Font> fonts{};           ///< kSmallFont, kLargeFont, or of `zstrip font`
  std::span<const Sprite> sprites{};       ///< later ones over earlier ones
  std::span<const Label> labels{};         ///< later ones over earlier ones
};

// ASCII in cells of 6x8 pixels, and the same letters smoothed in 12x16. What a program does not use takes no flash:
// 2.3 KB the small one, 7 KB the large one.

namespace detail {

/// U+0020 to U+007E, and a box as U+FFFD.
inline constexpr std::size_t kFontGlyphs = 96;
inline constexpr std::size_t kSmallFontBytes = kFontGlyphs * 8;
inline constexpr std::size_t kLargeFontBytes = 5292;
extern const std::array<Glyph, kFontGlyphs> kSmallFontGlyphs, kLargeFontGlyphs;
extern const std::array<std::uint8_t, kSmallFontBytes> kSmallFontCoverage;
extern const std::array<std::uint8_t, kLargeFontBytes> kLargeFontCoverage;

}  // namespace detail

/// 6 pixels a letter, 9 a line.
inline constexpr Font kSmallFont{.glyphs = detail::kSmallFontGlyphs,
                                 .coverage = detail::kSmallFontCoverage,
                                 .coverage_bits = 1,
                                 .line_height = 9,
                                 .baseline = 7};
/// 12 pixels a letter, 18 a line.
inline constexpr Font kLargeFont{.glyphs = detail::kLargeFontGlyphs,
                                 .coverage = detail::kLargeFontCoverage,
                                 .coverage_bits = 4,
                                 .line_height = 18,
                                 .baseline = 14};

/// Over the RGB565 pixels of a rectangle of the picture, which have no gaps. Renderers with effect::overlay do it by
/// themselves; this is for pixels of draw_over, and of other origin. `overlay` has passed validate().
void draw_overlay(const Overlay& overlay, const Rect& area, std::uint16_t* pixels);

}  // namespace zstrip
