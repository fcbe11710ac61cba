// What the window holds: the picture, enlarged, perhaps with its strips, and lines of text below it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "image/rgb_image.hpp"
#include "zstrip/view.hpp"

namespace zstrip::sim {

/// The smallest width in which the lines of text are whole.
inline constexpr std::uint32_t kTextWidth = 720;

/// Pixels of the border of a strip, in the picture's pixels: those of its first row and column.
struct StripMarks {
  std::span<const Rect> strips{};  ///< none: no marks
  std::size_t drawing = SIZE_MAX;  ///< the strip that is lit
};

/// Every pixel becomes a square of `scale` pixels. Each line of text becomes one below; at most as wide as the window.
RgbImage window_picture(const RgbImage& picture, std::uint32_t scale, const StripMarks& marks,
                        std::span<const std::string> text);

}  // namespace zstrip::sim
