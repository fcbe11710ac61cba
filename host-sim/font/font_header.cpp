// Writes a font as a C++ header; see font_header.hpp.
#include "font/font_header.hpp"

#include <fmt/format.h>

#include "bake/literals.hpp"
#include "text/number.hpp"
#include "text/text.hpp"

namespace zstrip::sim {
std::string to_font_header(const Font& font, const std::string& source, const std::string& name_space) {
  std::string text = fmt::format(
      "// A font for zstrip, made of {}: {}, {} a line, {}.\n"
      "// Written by `zstrip font`: make it again rather than edit. The licence of its source goes for it, too.\n"
      "//     const zstrip::Overlay overlay{{.fonts = {{&{}::kFont, 1}}, .labels = labels}};\n"
      "#pragma once\n\n#include <cstdint>\n\n#include \"zstrip/overlay.hpp\"\n"
      "#include \"zstrip/scene/valid_overlay.hpp\"\n\nnamespace {} {{\n\n",
      printable(source), counted(font.glyphs.size(), "character"), counted(font.line_height, "pixel"),
      counted(font.glyphs.size_bytes() + font.coverage.size_bytes(), "byte"), name_space, name_space);
  text += "/// Code point, offset, width, height, left, top, advance.\n";
  text += array_definition("zstrip::Glyph", "kGlyphs", font.glyphs);
  if (!font.coverage.empty()) text += array_definition("std::uint8_t", "kCoverage", font.coverage);
  text += fmt::format(
      "inline constexpr zstrip::Font kFont{{.glyphs = kGlyphs,\n{pad}.coverage = {},\n{pad}.coverage_bits = {},\n"
      "{pad}.line_height = {},\n{pad}.baseline = {},\n{pad}.replacement = 0x{:04X}}};\n"
      "static_assert(zstrip::detail::valid_font(kFont));\n\n}}  // namespace {}\n",
      font.coverage.empty() ? "{}" : "kCoverage", font.coverage_bits, font.line_height, font.baseline, font.replacement,
      name_space, fmt::arg("pad", "                                    "));
  return text;
}

}  // namespace zstrip::sim
