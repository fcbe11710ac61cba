// A font with outlines (TrueType, OpenType), converted to glyphs of pixels by FreeType.
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
  std::uint32_t size = 16;                   ///< pixels of the em square, kMinFontSize..kMaxFontSize
  std::uint8_t bits = 4;                     ///< of a pixel's coverage: 1, 4 or 8
  std::vector<std::uint32_t> characters;     ///< ascending
  std::optional<std::uint32_t> replacement;  ///< for what is missing; none: U+FFFD, if the file has it
};

struct ConvertedFont {
  std::vector<Glyph> glyphs;
  std::vector<std::uint8_t> coverage;
  Font font;                           ///< passes the checks; views `glyphs` and `coverage`
  std::vector<std::uint32_t> missing;  ///< characters that the file does not have

  ConvertedFont() = default;
  ConvertedFont(ConvertedFont&&) = default;  ///< memory that is viewed stays where it is
  ConvertedFont& operator=(ConvertedFont&&) = default;
};

Result<ConvertedFont> convert_font(const FontRequest& request);

}  // namespace zstrip::sim
