// The pixels of the window: the picture, enlarged or reduced, perhaps with its strips, and lines of text below it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "image/rgb_image.hpp"
#include "zstrip/view.hpp"

namespace zstrip::sim {

/// Pixels.
struct WindowSize {
  std::uint32_t width = 1, height = 1;
  bool operator==(const WindowSize&) const = default;
};

/// A pixel of the picture becomes a square of `enlarged` pixels; a square of `reduced` pixels becomes their mean.
struct PictureScale {
  std::uint32_t enlarged = 1, reduced = 1;
  bool operator==(const PictureScale&) const = default;
};

/// Pixels of the border of a strip, in the picture's pixels: those of its first row and column.
struct StripMarks {
  std::span<const Rect> strips{};  ///< none: no marks
  std::size_t drawing = SIZE_MAX;  ///< the strip that is lit
};

using TextLines = std::span<const std::string>;

/// The size that a window for this picture and this text should have: of `scale` or, where `room` is too small for
/// that, of the largest scale that fits; never larger than `room`.
WindowSize wanted_window(const WindowSize& picture, std::uint32_t scale, TextLines text, const WindowSize& room);

/// The largest scale in a window of this size, above the text.
PictureScale scale_in(const WindowSize& window, const WindowSize& picture, TextLines text);

/// The picture in the middle of what the text leaves. Lines are broken between words where the window is narrow; the
/// text is left out where it would take more than half of a window that is too low for both.
RgbImage window_picture(const RgbImage& picture, const StripMarks& marks, TextLines text, const WindowSize& window);

/// Text alone, in smaller letters where it does not fit otherwise. The second half of a broken line begins `indent`
/// letters further to the right.
RgbImage text_page(TextLines text, std::size_t indent, const WindowSize& window);

}  // namespace zstrip::sim
