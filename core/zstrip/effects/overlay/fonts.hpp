// Two fonts: ASCII in cells of 6x8 pixels, and the same letters smoothed in 12x16. What a program does not use takes no
// flash: 2.3 KB the small one, 7 KB the large one.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "zstrip/overlay.hpp"

namespace zstrip {

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

}  // namespace zstrip
