// Shows text on a display after a failure. Needs no renderer, and half a kilobyte of stack.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "zstrip_hal/display.hpp"
#include "zstrip_hal/error.hpp"

namespace zstrip::hal {

namespace detail {

/// Rows of three pixels from top to bottom, one octal digit each.
constexpr std::uint16_t glyph(char character) {
  constexpr std::array<std::uint16_t, 26> kLetters{
      025755, 065656, 034443, 065556, 074647, 074644, 034553, 055755, 072227, 011152, 055655, 044447, 057755,
      065555, 025552, 065644, 025563, 065655, 034216, 072222, 055557, 055522, 055775, 055255, 055222, 071247};
  constexpr std::array<std::uint16_t, 10> kDigits{075557, 026227, 061247, 061216, 055711,
                                                  074616, 034652, 071222, 025252, 025316};
  if (character >= 'a' && character <= 'z') return kLetters[static_cast<std::size_t>(character - 'a')];
  if (character >= 'A' && character <= 'Z') return kLetters[static_cast<std::size_t>(character - 'A')];
  if (character >= '0' && character <= '9') return kDigits[static_cast<std::size_t>(character - '0')];
  switch (character) {
    case ' ': return 0;
    case '.': return 000002;
    case ',': return 000024;
    case ':': return 002020;
    case ';': return 002024;
    case '-': return 000700;
    case '\'': return 022000;
    default: return 061202;  // a question mark
  }
}

inline constexpr std::uint16_t kCellWidth = 8, kCellHeight = 16;  // pages of eight rows end with cells
inline constexpr std::uint32_t kGlyphRows = 5;

/// Returns the glyph twice as wide and three times as high, white on black.
constexpr std::array<std::byte, kCellWidth * kCellHeight * 4> cell(char character, DisplayFormat format) {
  std::array<std::byte, kCellWidth * kCellHeight * 4> bytes{};
  const std::uint32_t row_bytes = bytes_per_row(kCellWidth, format);
  const std::uint32_t bits = row_bytes * 8 / kCellWidth;
  const auto lit = [format](std::uint32_t byte) {
    if (format == DisplayFormat::rgb666) return std::byte{0xFC};
    return format == DisplayFormat::xrgb8888 && byte % 4 == 3 ? std::byte{0} : std::byte{0xFF};
  };
  for (std::uint32_t y = 0; y < 3 * kGlyphRows; ++y) {
    const unsigned row = glyph(character) >> (3 * (kGlyphRows - 1 - y / 3)) & 7U;
    for (std::uint32_t bit = 0; bit < 6 * bits; ++bit) {
      if ((row >> (2 - bit / bits / 2) & 1U) == 0) continue;
      const std::uint32_t byte = bit / 8;
      bytes[y * row_bytes + byte] |= lit(byte) & static_cast<std::byte>(0x80U >> (bit % 8));
    }
  }
  return bytes;
}

/// Call it between begin_frame() and end_frame().
template <Display Panel>
Error write_cells(Panel& panel, std::string_view text) {
  const std::uint16_t columns = panel.width() / kCellWidth, lines = panel.height() / kCellHeight;
  std::size_t next = 0;
  for (std::uint16_t line = 0; line < lines; ++line) {
    for (std::uint16_t column = 0; column < columns; ++column, ++next) {
      auto pixels = cell(next < text.size() ? text[next] : ' ', panel.format());
      const Area area{static_cast<std::uint16_t>(column * kCellWidth), static_cast<std::uint16_t>(line * kCellHeight),
                      kCellWidth, kCellHeight};
      const std::size_t bytes = bytes_per_row(area.width, panel.format()) * std::size_t{area.height};
      if (const Error error = panel.write(area, std::span(pixels).first(bytes)); error != Error::none) return error;
      if (const Error error = panel.wait(); error != Error::none) return error;
    }
  }
  return Error::none;
}

}  // namespace detail

/// Fills the display with `text`, in capitals, from the upper left corner, line by line as wide as the display. Text
/// that does not fit is left out. A right or bottom border of the display narrower than 8 or lower than 16 pixels
/// keeps its content. Shows letters, digits, space and .,:;-' ; any other character becomes a question mark. Stops at
/// the first error.
template <Display Panel>
Error show_message(Panel& panel, std::string_view text) {
  if (const Error error = panel.begin_frame(); error != Error::none) return error;
  const Error written = detail::write_cells(panel, text);
  const Error ended = panel.end_frame();
  return written != Error::none ? written : ended;
}

}  // namespace zstrip::hal
