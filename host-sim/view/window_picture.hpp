// The pixels of the window: the picture, enlarged or reduced, optionally with its strips, and lines of text below it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "image/rgb_image.hpp"
#include "zstrip/view.hpp"

namespace zstrip::sim {

/// A size in pixels.
struct WindowSize {
  std::uint32_t width = 1, height = 1;
  bool operator==(const WindowSize&) const = default;
};

/// A pixel, from the upper left corner of the picture.
struct PicturePixel {
  std::uint32_t x = 0, y = 0;
  bool operator==(const PicturePixel&) const = default;
};

/// A pixel of the picture becomes a square of `enlarged` pixels; a square of `reduced` pixels becomes their mean.
struct PictureScale {
  std::uint32_t enlarged = 1, reduced = 1;
  bool operator==(const PictureScale&) const = default;
};

/// Draws the border of each strip on the first row and column of its pixels in the picture.
struct StripMarks {
  std::span<const Rect> strips{};  ///< empty: no marks
  std::size_t drawing = SIZE_MAX;  ///< the strip that is highlighted
};

using TextLines = std::span<const std::string>;

/// Returns the size of a window for this picture and text: with `scale` or, if `room` is too small, with the largest
/// scale that fits; never larger than `room`.
WindowSize wanted_window(const WindowSize& picture, std::uint32_t scale, TextLines text, const WindowSize& room);

/// Returns the largest scale that fits in a window of this size, above the text.
PictureScale scale_in(const WindowSize& window, const WindowSize& picture, TextLines text);

/// Returns the pixel of the picture that a pixel of the window shows with this picture and text; nothing outside
/// the picture. In a reduced picture it is the first of several.
std::optional<PicturePixel> pixel_at(const WindowSize& window, const WindowSize& picture, TextLines text,
                                     std::int64_t x, std::int64_t y);

/// Draws the picture in the middle of the space above the text. Lines are broken between words if the window is narrow.
/// The text is left out if it would take more than half of a window that is too low for both.
RgbImage window_picture(const RgbImage& picture, const StripMarks& marks, TextLines text, const WindowSize& window);

/// Draws only text, in smaller letters if it does not fit otherwise. The second part of a broken line is indented by
/// `indent` more letters.
RgbImage text_page(TextLines text, std::size_t indent, const WindowSize& window);

}  // namespace zstrip::sim
