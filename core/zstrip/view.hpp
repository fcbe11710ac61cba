// The picture: its size and how its pixels lie in memory.
#pragma once

#include <algorithm>
#include <cstdint>

#include "zstrip/base/language.hpp"

namespace zstrip {

/// docs/conventions.md, "Picture formats", defines the bytes of each. hal::DisplayFormat has the same names in order.
enum class PixelFormat : std::uint8_t {
  rgb565,          ///< two bytes, the low one first
  rgb565_swapped,  ///< two bytes, the high one first: most panels on SPI
  gray4,           ///< 16 greys, two pixels a byte
  mono,            ///< one bit, eight pixels a byte
  rgb666,          ///< three bytes
  rgb444,          ///< 12 bits, two pixels in three bytes
  xrgb8888,        ///< four bytes: Linux framebuffers
};
/// The limit for checks of values from outside.
inline constexpr PixelFormat kLastPixelFormat = PixelFormat::xrgb8888;

/// True if the format has fewer bits than RGB565, the format in which strips are drawn.
constexpr bool is_narrow(PixelFormat format) {
  return format == PixelFormat::gray4 || format == PixelFormat::mono || format == PixelFormat::rgb444;
}

/// Size and format of the picture.
struct View {
  std::uint16_t width = 0;                   ///< 1..4096
  std::uint16_t height = 0;                  ///< 1..4096
  PixelFormat format = PixelFormat::rgb565;  ///< format of the strips that draw_strip writes
  /// Dithers where colours are reduced to fewer bits (docs/conventions.md, "Dithering"). Needs a renderer with
  /// effects_of(view); other renderers ignore it and have no code for it.
  bool dither = false;
  /// Samples of a pixel: 1, 2 (side by side) or 4 (two by two). All samples are drawn, and a pixel is the mean of its
  /// samples (docs/conventions.md, "Samples"). A row or column has at most kMaxViewSize samples. 2 and 4 need
  /// effects_of(view).
  std::uint8_t samples = 1;
};

/// True if gradients, fog and spheres are dithered while they are drawn. In narrow formats pixels are dithered
/// afterwards.
constexpr bool dithers_colours(const View& view) { return view.dither && !is_narrow(view.format); }

inline constexpr std::uint16_t kMaxViewSize = 4096;  ///< samples in a row or column
inline constexpr std::uint8_t kMaxSamples = 4;       ///< maximum for a pixel

/// True if size and format are valid for one sample a pixel.
constexpr bool valid_size_and_format(const View& view) {
  return view.width >= 1 && view.height >= 1 && view.width <= kMaxViewSize && view.height <= kMaxViewSize &&
         view.format <= kLastPixelFormat;
}
/// True if View::samples is 1, 2 or 4.
constexpr bool valid_samples(const View& view) {
  return view.samples == 1 || view.samples == 2 || view.samples == kMaxSamples;
}
/// Returns the samples of a pixel side by side.
constexpr std::uint32_t sample_columns(const View& view) { return view.samples > 1 ? 2 : 1; }
/// Returns the samples of a pixel one below the other.
constexpr std::uint32_t sample_rows(const View& view) { return view.samples > 2 ? 2 : 1; }
/// Returns the samples in the picture's longer row or column; at most kMaxViewSize in a valid view.
constexpr std::uint32_t samples_a_side(const View& view) {
  const std::uint32_t across = view.width * sample_columns(view), down = view.height * sample_rows(view);
  return across > down ? across : down;
}

/// Returns the bytes of one row of pixels; every row starts at a byte.
constexpr std::uint32_t bytes_per_row(std::uint16_t width, PixelFormat format) {
  switch (format) {
    case PixelFormat::gray4: return (width + 1U) / 2U;
    case PixelFormat::mono: return (width + 7U) / 8U;
    case PixelFormat::rgb666: return 3U * width;
    case PixelFormat::rgb444: return (3U * width + 1U) / 2U;
    case PixelFormat::xrgb8888: return 4U * width;
    default: return 2U * width;
  }
}

/// Pixels x in [left, right), y in [top, bottom).
struct Rect {
  std::int32_t left = 0, top = 0, right = 0, bottom = 0;  ///< pixels; right and bottom are outside
  /// Returns pixels.
  constexpr std::int32_t width() const { return right - left; }
  /// Returns pixels.
  constexpr std::int32_t height() const { return bottom - top; }
  /// Returns the intersection with `other`; empty if they do not overlap.
  constexpr Rect cut_to(const Rect& other) const {
    return {std::max(left, other.left), std::max(top, other.top), std::min(right, other.right),
            std::min(bottom, other.bottom)};
  }
  /// True if the rectangles have a common pixel.
  constexpr bool touches(const Rect& other) const {
    return std::max(left, other.left) < std::min(right, other.right) &&
           std::max(top, other.top) < std::min(bottom, other.bottom);
  }
  /// True if the rectangle has no pixels.
  constexpr bool empty() const { return right <= left || bottom <= top; }
  friend constexpr bool operator==(const Rect&, const Rect&) = default;
};

}  // namespace zstrip
