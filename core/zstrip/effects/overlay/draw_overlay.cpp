// Draws sprites, backgrounds and glyphs: each is a rectangle, clipped and blended row by row.
#include "zstrip/overlay.hpp"

#include <cstddef>

#include "zstrip/effects/overlay/text_line.hpp"
#include "zstrip/scene/valid_overlay.hpp"

namespace zstrip {
namespace {

struct Target {
  Rect area;
  std::uint16_t* pixels;
};

/// A rectangle of the picture and its contents.
struct Piece {
  Rect place;
  const std::uint16_t* colours;  ///< null: one colour
  const std::uint8_t* coverage;  ///< null: completely covered
  std::uint32_t bits;            ///< bits of a pixel's coverage
  Colour colour;                 ///< its alpha is for all pixels
};

constexpr std::uint16_t to_rgb565(const Colour& c) {
  return static_cast<std::uint16_t>((c.r & 0xF8) << 8 | (c.g & 0xFC) << 3 | c.b >> 3);
}

/// Returns value / 255, rounded to nearest; 0 <= value <= 65535.
constexpr std::uint32_t over_255(std::uint32_t value) {
  value += 128;
  return (value + (value >> 8)) >> 8;
}

/// Returns (alpha over + (255 - alpha) under) / 255 for each channel, rounded to nearest.
constexpr std::uint16_t mixed(std::uint32_t over, std::uint32_t under, std::uint32_t alpha) {
  const auto mix = [&](std::uint32_t shift, std::uint32_t mask) {
    return over_255(alpha * (over >> shift & mask) + (255 - alpha) * (under >> shift & mask)) << shift;
  };
  return static_cast<std::uint16_t>(mix(11, 31) | mix(5, 63) | mix(0, 31));
}

/// Returns the coverage of a pixel, 0..255.
constexpr std::uint32_t coverage_at(const std::uint8_t* row, std::uint32_t x, std::uint32_t bits) {
  if (bits == 8) return row[x];
  if (bits == 4) return (row[x / 2] >> (x % 2 == 0 ? 4 : 0) & 15U) * 17U;
  return (row[x / 8] >> (7 - x % 8) & 1U) * 255U;
}

void draw(const Piece& piece, const Target& target) {
  const Rect& place = piece.place;
  const Rect part = place.cut_to(target.area);
  if (part.empty()) return;
  const auto width = static_cast<std::uint32_t>(place.width());
  const auto first = static_cast<std::uint32_t>(part.left - place.left);
  const std::uint32_t row_bytes = detail::coverage_row_bytes(width, piece.bits);
  const std::uint16_t one_colour = to_rgb565(piece.colour);
  const std::uint32_t opacity = piece.colour.a;
  for (std::int32_t y = part.top; y < part.bottom; ++y) {
    const auto row = static_cast<std::uint32_t>(y - place.top);
    const std::uint16_t* const colours = piece.colours == nullptr ? nullptr : piece.colours + row * width;
    const std::uint8_t* const coverage = piece.coverage == nullptr ? nullptr : piece.coverage + row * row_bytes;
    std::uint16_t* pixel = target.pixels + (y - target.area.top) * target.area.width() + (part.left - target.area.left);
    const std::uint16_t* const end = pixel + part.width();
    for (std::uint32_t x = first; pixel != end; ++pixel, ++x) {
      const std::uint32_t alpha =
          coverage == nullptr ? opacity : over_255(coverage_at(coverage, x, piece.bits) * opacity);
      if (alpha == 0) continue;
      const std::uint16_t colour = colours == nullptr ? one_colour : colours[x];
      *pixel = alpha == 255 ? colour : mixed(colour, *pixel, alpha);
    }
  }
}

void draw(const Sprite& sprite, const OverlayImage& image, const Target& target) {
  draw({.place = {sprite.x, sprite.y, sprite.x + image.width, sprite.y + image.height},
        .colours = image.colours.empty() ? nullptr : image.colours.data(),
        .coverage = image.coverage.empty() ? nullptr : image.coverage.data(),
        .bits = image.coverage_bits,
        .colour = sprite.colour},
       target);
}

/// `top`: the line's upper border.
void draw_line(const Label& label, const Font& font, std::span<const char> line, std::int32_t top,
               const Target& target) {
  const bool has_background = label.background.a != 0;
  const std::int32_t width = label.alignment != Alignment::left || has_background ? detail::width_of(font, line) : 0;
  std::int32_t pen = label.x;
  if (label.alignment == Alignment::centre) pen -= width >> 1;
  if (label.alignment == Alignment::right) pen -= width;
  if (has_background) {
    draw({.place = {pen, top, pen + width, top + font.line_height},
          .colours = nullptr,
          .coverage = nullptr,
          .bits = 8,
          .colour = label.background},
         target);
  }
  while (!line.empty()) {
    const Glyph* const glyph = detail::take_glyph(font, line);
    if (glyph == nullptr) continue;
    const std::int32_t x = pen + glyph->left, y = top + font.baseline - glyph->top;
    draw({.place = {x, y, x + glyph->width, y + glyph->height},
          .colours = nullptr,
          .coverage = font.coverage.data() + glyph->offset,
          .bits = font.coverage_bits,
          .colour = label.colour},
         target);
    pen += glyph->advance;
  }
}

void draw(const Label& label, const Font& font, const Target& target) {
  const std::int32_t height = font.line_height;
  std::span<const char> text = detail::whole_text(label.text);
  for (std::int32_t top = label.y; !text.empty() && top - height < target.area.bottom; top += height) {
    const std::span<const char> line = detail::take_line(text);
    if (top + 2 * height > target.area.top) draw_line(label, font, line, top, target);
  }
}

}  // namespace

// The pixels are written through the target.
// NOLINTNEXTLINE(readability-non-const-parameter)
void draw_overlay(const Overlay& overlay, const Rect& area, std::uint16_t* pixels) {
  const Target target{area, pixels};
  for (const Sprite& sprite : overlay.sprites) draw(sprite, overlay.images[sprite.image], target);
  for (const Label& label : overlay.labels) draw(label, overlay.fonts[label.font], target);
}

}  // namespace zstrip
