// What an overlay makes of a whole picture: the definition of docs/conventions.md, one pixel after the other, in real
// numbers.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "drawn.hpp"
#include "zstrip/overlay.hpp"

namespace overlay_oracle {

using namespace zstrip;

/// Characters of a text, -1 for a byte that begins none: by table 3-7 of the Unicode standard.
inline std::vector<std::int64_t> characters(const std::string& text) {
  struct Row {
    int low[4], high[4], bytes, first_bits;
  };
  static const Row kRows[] = {{{0x00}, {0x7F}, 1, 7},
                              {{0xC2, 0x80}, {0xDF, 0xBF}, 2, 5},
                              {{0xE0, 0xA0, 0x80}, {0xE0, 0xBF, 0xBF}, 3, 4},
                              {{0xE1, 0x80, 0x80}, {0xEC, 0xBF, 0xBF}, 3, 4},
                              {{0xED, 0x80, 0x80}, {0xED, 0x9F, 0xBF}, 3, 4},
                              {{0xEE, 0x80, 0x80}, {0xEF, 0xBF, 0xBF}, 3, 4},
                              {{0xF0, 0x90, 0x80, 0x80}, {0xF0, 0xBF, 0xBF, 0xBF}, 4, 3},
                              {{0xF1, 0x80, 0x80, 0x80}, {0xF3, 0xBF, 0xBF, 0xBF}, 4, 3},
                              {{0xF4, 0x80, 0x80, 0x80}, {0xF4, 0x8F, 0xBF, 0xBF}, 4, 3}};
  std::vector<std::int64_t> result;
  for (std::size_t at = 0; at < text.size();) {
    std::int64_t found = -1;
    int taken = 1;
    for (const Row& row : kRows) {
      if (at + static_cast<std::size_t>(row.bytes) > text.size()) continue;
      bool fits = true;
      std::int64_t value = 0;
      for (int i = 0; i < row.bytes; ++i) {
        const int byte = static_cast<unsigned char>(text[at + static_cast<std::size_t>(i)]);
        fits = fits && byte >= row.low[i] && byte <= row.high[i];
        value = i == 0 ? byte % (1 << row.first_bits) : value * 64 + byte % 64;
      }
      if (fits) found = value, taken = row.bytes;
    }
    result.push_back(found);
    at += static_cast<std::size_t>(taken);
  }
  return result;
}

/// What is drawn: a rectangle, perhaps with colours, perhaps with coverage.
struct Part {
  std::int64_t x, y, width, height;
  const std::uint16_t* colours;
  const std::uint8_t* coverage;
  int bits;
  Colour colour;
};

inline const Glyph* glyph_for(const Font& font, std::int64_t character) {
  for (const Glyph& glyph : font.glyphs) {
    if (glyph.code_point == character) return &glyph;
  }
  return nullptr;
}

inline void add_label(const Label& label, const Font& font, std::vector<Part>& parts) {
  std::string text(label.text.begin(), label.text.end());
  text = text.substr(0, text.find('\0'));
  std::vector<std::vector<const Glyph*>> lines(1);
  for (const std::int64_t character : characters(text)) {
    if (character == '\n') {
      lines.emplace_back();
      continue;
    }
    const Glyph* glyph = glyph_for(font, character);
    if (glyph == nullptr) glyph = glyph_for(font, font.replacement);
    if (glyph != nullptr) lines.back().push_back(glyph);
  }
  std::int64_t top = label.y;
  for (const auto& line : lines) {
    std::int64_t width = 0;
    for (const Glyph* glyph : line) width += glyph->advance;
    std::int64_t x = label.x;
    if (label.alignment == Alignment::centre) x -= width / 2;
    if (label.alignment == Alignment::right) x -= width;
    parts.push_back({x, top, width, font.line_height, nullptr, nullptr, 8, label.background});
    for (const Glyph* glyph : line) {
      parts.push_back({x + glyph->left, top + font.baseline - glyph->top, glyph->width, glyph->height, nullptr,
                       font.coverage.data() + glyph->offset, font.coverage_bits, label.colour});
      x += glyph->advance;
    }
    top += font.line_height;
  }
}

inline std::vector<Part> parts_of(const Overlay& overlay) {
  std::vector<Part> parts;
  for (const Sprite& sprite : overlay.sprites) {
    const OverlayImage& image = overlay.images[sprite.image];
    parts.push_back({sprite.x, sprite.y, image.width, image.height,
                     image.colours.empty() ? nullptr : image.colours.data(),
                     image.coverage.empty() ? nullptr : image.coverage.data(), image.coverage_bits, sprite.colour});
  }
  for (const Label& label : overlay.labels) add_label(label, overlay.fonts[label.font], parts);
  return parts;
}

/// 0..1: bit by bit.
inline double coverage_of(const Part& part, std::int64_t column, std::int64_t row) {
  if (part.coverage == nullptr) return 1;
  const std::int64_t row_bits = (part.width * part.bits + 7) / 8 * 8;
  int level = 0;
  for (int i = 0; i < part.bits; ++i) {
    const std::int64_t bit = row * row_bits + column * part.bits + i;
    level = 2 * level + (part.coverage[bit / 8] / (1 << (7 - bit % 8))) % 2;
  }
  return level / (std::exp2(part.bits) - 1);
}

inline std::uint16_t blended(const Part& part, std::int64_t column, std::int64_t row, std::uint16_t under) {
  const double alpha = std::round(coverage_of(part, column, row) * part.colour.a);
  const int over = part.colours != nullptr ? part.colours[row * part.width + column]
                                           : part.colour.r / 8 * 2048 + part.colour.g / 4 * 32 + part.colour.b / 8;
  const auto channel = [&](int unit, int levels) {
    const double own = over / unit % levels, other = under / unit % levels;
    return static_cast<int>(std::round((alpha * own + (255 - alpha) * other) / 255)) * unit;
  };
  return static_cast<std::uint16_t>(channel(2048, 32) + channel(32, 64) + channel(1, 32));
}

/// The picture with the overlay over it.
inline effects_test::Drawn over(effects_test::Drawn picture, const Overlay& overlay) {
  const std::vector<Part> parts = parts_of(overlay);
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      std::uint16_t& pixel = picture.pixels[static_cast<std::size_t>(y * picture.width + x)];
      for (const Part& part : parts) {
        const std::int64_t column = x - part.x, row = y - part.y;
        if (column < 0 || column >= part.width || row < 0 || row >= part.height) continue;
        pixel = blended(part, column, row, pixel);
      }
    }
  }
  return picture;
}

}  // namespace overlay_oracle
