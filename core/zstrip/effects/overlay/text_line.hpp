// Splits a label into lines and glyphs, and measures lines.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip/effects/overlay/utf8.hpp"
#include "zstrip/overlay.hpp"

namespace zstrip::detail {

constexpr std::span<const char> whole_text(std::span<const char> text) {
  std::size_t size = 0;
  while (size < text.size() && text[size] != '\0') ++size;
  return text.first(size);
}

/// Removes the first line and the line feed after it from a text, and returns the line.
constexpr std::span<const char> take_line(std::span<const char>& text) {
  std::size_t size = 0;
  while (size < text.size() && text[size] != '\n') ++size;
  const std::span<const char> line = text.first(size);
  text = text.subspan(size < text.size() ? size + 1 : size);
  return line;
}

/// Returns the glyph of a code point, or null if the font has none.
constexpr const Glyph* find_glyph(const Font& font, std::uint32_t code_point) {
  std::size_t first = 0, count = font.glyphs.size();
  while (count > 0) {
    const std::size_t half = count / 2;
    if (font.glyphs[first + half].code_point < code_point) {
      first += half + 1;
      count -= half + 1;
    } else {
      count = half;
    }
  }
  const bool found = first < font.glyphs.size() && font.glyphs[first].code_point == code_point;
  return found ? &font.glyphs[first] : nullptr;
}

/// Removes the first character from a line that is not empty, and returns its glyph; null: nothing is shown for it.
constexpr const Glyph* take_glyph(const Font& font, std::span<const char>& line) {
  const Glyph* const own = find_glyph(font, take_code_point(line));
  return own != nullptr ? own : find_glyph(font, font.replacement);
}

/// Returns the pixels by which the pen moves.
constexpr std::int32_t width_of(const Font& font, std::span<const char> line) {
  std::int32_t width = 0;
  while (!line.empty()) {
    const Glyph* const glyph = take_glyph(font, line);
    if (glyph != nullptr) width += glyph->advance;
  }
  return width;
}

}  // namespace zstrip::detail
