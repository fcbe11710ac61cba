// The interface of a display: a size, a pixel format, and functions that send it rectangles of pixels.
//
// Displays are concepts, not base classes: a firmware has one or two panels, known when it is compiled, so that calls
// inline and no table of functions takes RAM. Code for "any display" is a template (present.hpp is the only one here).
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

#include "zstrip_hal/error.hpp"

namespace zstrip::hal {

/// The layout of a display's pixels in memory. Rows follow each other; every row starts at a byte. A renderer must
/// draw in the format of its display: zstrip's core takes it in View as a PixelFormat, whose values have the same
/// names.
enum class DisplayFormat : std::uint8_t {
  rgb565,          ///< two bytes, the low one first; red in bits 15..11
  rgb565_swapped,  ///< two bytes, the high one first
  gray4,           ///< two pixels a byte, the left one in the high nibble; 15 is lightest
  mono,            ///< eight pixels a byte, the leftmost in the highest bit; 1 is lit
  rgb666,          ///< three bytes: red, green, blue, each in the upper six bits, the lower two 0
  rgb444,          ///< two pixels in three bytes, red, green, blue of the left one first, high nibbles first
  xrgb8888,        ///< four bytes: blue, green, red, 0; a 32-bit word with red in bits 23..16
};

/// Pixels x in [left, left + width), y in [top, top + height); the origin is the upper left corner.
struct Area {
  std::uint16_t left = 0;    ///< pixels, from the picture's left border
  std::uint16_t top = 0;     ///< pixels, from its upper border
  std::uint16_t width = 0;   ///< pixels
  std::uint16_t height = 0;  ///< pixels
  friend constexpr bool operator==(const Area&, const Area&) = default;
};

/// Bytes of one row of pixels.
constexpr std::uint32_t bytes_per_row(std::uint16_t width, DisplayFormat format) {
  switch (format) {
    case DisplayFormat::gray4: return (width + 1U) / 2U;
    case DisplayFormat::mono: return (width + 7U) / 8U;
    case DisplayFormat::rgb666: return 3U * width;
    case DisplayFormat::rgb444: return (3U * width + 1U) / 2U;
    case DisplayFormat::xrgb8888: return 4U * width;
    default: return 2U * width;
  }
}

/// True if the area is not empty and lies inside a display of this size.
constexpr bool contains(std::uint16_t width, std::uint16_t height, const Area& area) {
  return area.width > 0 && area.height > 0 && area.left + area.width <= width && area.top + area.height <= height;
}

/// A display that was started. Between begin_frame and end_frame, write() sends rectangles:
///   - write() takes the first bytes_per_row(area.width) * area.height bytes of `pixels`. It may return while they are
///     still being sent: they must stay alive and unchanged until wait() returns. At most one write is under way; the
///     caller waits before the next. Most displays take std::span<const std::byte>; one that takes std::span<std::byte>
///     may change the pixels.
///   - wait() returns when nothing is under way, with the error of that write. Called when idle, it returns at once.
///   - end_frame() makes the frame complete; nothing may be under way.
/// Pixels that were not written keep their value: a frame may write only the rectangles in which the picture differs
/// from the one before. A display whose memory has several pixels a byte may need areas that begin and end at whole
/// bytes, in x or in y, and returns Error::alignment otherwise; its documentation states that. After an error of
/// write() or wait() the display is idle and its picture of this frame is undefined. A new frame may begin then, and
/// every rectangle that it writes is shown correctly. end_frame() is called after an error too. Use a display from one
/// thread, core, or interrupt level, at a time. The display refers to its bus, which must outlive it.
template <class T>
concept Display = requires(T& display, const T& view, const Area& area, std::span<std::byte> pixels) {
  { view.width() } -> std::same_as<std::uint16_t>;
  { view.height() } -> std::same_as<std::uint16_t>;
  { view.format() } -> std::same_as<DisplayFormat>;
  { display.begin_frame() } -> std::same_as<Error>;
  { display.write(area, pixels) } -> std::same_as<Error>;
  { display.wait() } -> std::same_as<Error>;
  { display.end_frame() } -> std::same_as<Error>;
};

}  // namespace zstrip::hal
