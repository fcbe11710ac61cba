// Checks an overlay: a valid one is never read out of bounds, and no position of a pixel overflows.
#pragma once

#include <cstdint>

#include "zstrip/overlay.hpp"
#include "zstrip/status.hpp"

namespace zstrip {

/// The part of an overlay that is not valid, in Status::available of Error::overlay.
enum class OverlayPart : std::uint8_t { image, font, sprite, label };

namespace detail {

constexpr std::uint32_t coverage_row_bytes(std::uint32_t width, std::uint32_t bits) { return (width * bits + 7) / 8; }

constexpr bool valid_coverage_bits(std::uint8_t bits) { return bits == 1 || bits == 4 || bits == 8; }

constexpr bool valid_image(const OverlayImage& image) {
  if (image.width < 1 || image.width > kMaxImageSize || image.height < 1 || image.height > kMaxImageSize) return false;
  if (!valid_coverage_bits(image.coverage_bits) || (image.colours.empty() && image.coverage.empty())) return false;
  const std::uint32_t pixels = std::uint32_t{image.width} * image.height;
  const std::uint32_t bytes = coverage_row_bytes(image.width, image.coverage_bits) * image.height;
  return (image.colours.empty() || image.colours.size() >= pixels) &&
         (image.coverage.empty() || image.coverage.size() >= bytes);
}

constexpr bool valid_glyph(const Font& font, const Glyph& glyph) {
  const auto within = [](std::int32_t place) { return place >= -kMaxGlyphPlace && place <= kMaxGlyphPlace; };
  const std::int32_t first = font.baseline - glyph.top;
  const std::uint64_t bytes = std::uint64_t{coverage_row_bytes(glyph.width, font.coverage_bits)} * glyph.height;
  return within(glyph.left) && within(glyph.top) && glyph.advance <= kMaxGlyphPlace && first >= -font.line_height &&
         first + glyph.height <= 2 * font.line_height && glyph.offset + bytes <= font.coverage.size();
}

constexpr bool valid_font(const Font& font) {
  if (!valid_coverage_bits(font.coverage_bits) || font.line_height < 1 || font.line_height > kMaxGlyphPlace ||
      font.baseline > kMaxGlyphPlace) {
    return false;
  }
  const Glyph* before = nullptr;
  for (const Glyph& glyph : font.glyphs) {
    if (!valid_glyph(font, glyph) || (before != nullptr && glyph.code_point <= before->code_point)) return false;
    before = &glyph;
  }
  return true;
}

constexpr Status not_valid(OverlayPart part, std::uint32_t index) {
  return {.error = Error::overlay, .needed = index, .available = static_cast<std::uint32_t>(part)};
}

/// Checks the parts that may change between frames: begin_frame calls this again.
constexpr Status validate_items(const Overlay& overlay) {
  for (std::uint32_t i = 0; i < overlay.sprites.size(); ++i) {
    if (overlay.sprites[i].image >= overlay.images.size()) return not_valid(OverlayPart::sprite, i);
  }
  for (std::uint32_t i = 0; i < overlay.labels.size(); ++i) {
    const Label& label = overlay.labels[i];
    if (label.font >= overlay.fonts.size() || label.alignment > Alignment::right ||
        label.text.size() > kMaxLabelBytes) {
      return not_valid(OverlayPart::label, i);
    }
  }
  return {};
}

}  // namespace detail

/// Checks the whole overlay. Time: linear in images, glyphs, sprites and labels.
constexpr Status validate(const Overlay& overlay) {
  for (std::uint32_t i = 0; i < overlay.images.size(); ++i) {
    if (!detail::valid_image(overlay.images[i])) return detail::not_valid(OverlayPart::image, i);
  }
  for (std::uint32_t i = 0; i < overlay.fonts.size(); ++i) {
    if (!detail::valid_font(overlay.fonts[i])) return detail::not_valid(OverlayPart::font, i);
  }
  return detail::validate_items(overlay);
}

}  // namespace zstrip
