// Converts a font with outlines (TrueType, OpenType) to glyphs of pixels, with FreeType.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "result.hpp"
#include "zstrip/overlay.hpp"

namespace zstrip::sim {

inline constexpr std::size_t kMaxFontBytes = std::size_t{64} << 20;  ///< of a font file; larger ones are refused
inline constexpr std::uint32_t kMinFontSize = 4, kMaxFontSize = 200;

struct FontRequest {
  std::filesystem::path file;
  std::uint32_t size = 16;                   ///< side of the em square in pixels, kMinFontSize..kMaxFontSize
  std::uint8_t bits = 4;                     ///< coverage bits of a pixel: 1, 4 or 8
  std::vector<std::uint32_t> characters;     ///< ascending
  std::optional<std::uint32_t> replacement;  ///< shown for missing characters; none: U+FFFD, if the file has it
};

struct ConvertedFont {
  std::vector<Glyph> glyphs;
  std::vector<std::uint8_t> coverage;
  Font font;                           ///< passes the checks; refers to `glyphs` and `coverage`
  std::vector<std::uint32_t> missing;  ///< characters that the file does not have

  ConvertedFont() = default;
  ConvertedFont(ConvertedFont&&) = default;  ///< memory that is referred to does not move
  ConvertedFont& operator=(ConvertedFont&&) = default;
};

Result<ConvertedFont> convert_font(const FontRequest& request);

}  // namespace zstrip::sim
