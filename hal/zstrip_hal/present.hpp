// The one loop that hands strips of pixels to a display. Firmware and host programs share it.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "zstrip_hal/display.hpp"
#include "zstrip_hal/error.hpp"

namespace zstrip::hal {

/// Draws strips of a frame that has begun: draw_strip(strip, pixels) returns a status, which converts to true on
/// success; a default-constructed one is success.
template <class T>
concept StripRenderer = requires(T& renderer, std::uint16_t strip, std::span<std::byte> pixels) {
  static_cast<bool>(renderer.draw_strip(strip, pixels));
};

/// A renderer that may know that it would draw a strip as in a frame before, without drawing it: fingerprint(strip)
/// is equal only if the pixels are; 0 says nothing.
template <class T>
concept HasFingerprints = requires(const T& renderer, std::uint16_t strip) {
  { renderer.fingerprint(strip) } -> std::same_as<std::uint32_t>;
};
/// A display that remembers fingerprints: shows(area, fingerprint) is true if it shows the strip with this fingerprint
/// in this area, and so needs neither its pixels nor a write(). Call it once for each strip, before its write(). It
/// remembers at most kStrips strips of a frame.
template <class T>
concept RemembersStrips = requires(T& display, const Area& area, std::uint32_t fingerprint) {
  { T::kStrips } -> std::convertible_to<std::size_t>;
  { display.shows(area, fingerprint) } -> std::same_as<bool>;
};

/// `count` strips of `rows` rows and `columns` pixels, from the left to the right of the display, then from its top to
/// its bottom; the last ones of a row or column may be smaller. `columns` 0: the display's width.
struct StripLayout {
  std::uint16_t count = 0;    ///< Plan::strips
  std::uint16_t rows = 0;     ///< pixels, Plan::strip_rows
  std::uint16_t columns = 0;  ///< pixels, Plan::strip_columns
};

/// The areas of a layout's strips on a display.
class StripAreas {
 public:
  /// `width`, `height`: the display's.
  constexpr StripAreas(const StripLayout& layout, std::uint16_t width, std::uint16_t height)
      : count_(layout.count),
        rows_(layout.rows),
        columns_(layout.columns == 0 ? width : layout.columns),
        width_(width),
        height_(height) {}

  /// True if the strips cover the display exactly. If not, do not call the other functions.
  constexpr bool cover() const {
    return rows_ != 0 && rows_ <= height_ && columns_ != 0 && columns_ <= width_ &&
           count_ == across() * parts(height_, rows_);
  }
  /// Returns the size of the largest strip in bytes.
  constexpr std::uint32_t bytes(DisplayFormat format) const { return rows_ * bytes_per_row(columns_, format); }
  /// Returns the area of the display that the strip covers, in pixels.
  constexpr Area area(std::uint16_t strip) const {
    const auto left = static_cast<std::uint16_t>(strip % across() * columns_);
    const auto top = static_cast<std::uint16_t>(strip / across() * rows_);
    return {left, top, part(width_, left, columns_), part(height_, top, rows_)};
  }

 private:
  static constexpr std::uint32_t parts(std::uint32_t whole, std::uint32_t part) { return (whole + part - 1) / part; }
  static constexpr std::uint16_t part(std::uint16_t whole, std::uint16_t first, std::uint16_t length) {
    return static_cast<std::uint16_t>(whole - first < length ? whole - first : length);
  }
  constexpr std::uint32_t across() const { return parts(width_, columns_); }

  std::uint16_t count_, rows_, columns_, width_, height_;
};

/// The buffers that strips are drawn into: each holds rows * bytes_per_row(columns) bytes, aligned as the renderer
/// needs. While one is being sent, the other is drawn. If `second` is empty, one buffer serves for both, and drawing
/// waits for the transfer: right for buses without DMA.
struct StripBuffers {
  std::span<std::byte> first;   ///< always needed
  std::span<std::byte> second;  ///< as large as the first one, or empty
};

/// Success if both sides succeeded; else the first error, and the strip at which it was noticed. (A display may report
/// a failed transfer one strip later.)
template <class DrawStatus>
struct [[nodiscard]] PresentResult {
  DrawStatus draw{};            ///< status of the renderer
  Error display = Error::none;  ///< error of the display
  std::uint16_t strip = 0;      ///< the strip at which an error was noticed, from 0
  /// True if both succeeded.
  constexpr explicit operator bool() const { return static_cast<bool>(draw) && display == Error::none; }
};

/// Draws all strips of the frame that `renderer` has begun, in order, and writes them to `display`. Strips are left out
/// that a renderer with fingerprints would draw as the display shows them. When it returns, also with an error, the
/// buffers are free and the display's frame has ended.
/// Display errors that present() itself returns: strip_layout, pixels_too_small.
template <StripRenderer Renderer, Display Panel>
auto present(Renderer& renderer, Panel& display, const StripLayout& layout, const StripBuffers& buffers) {
  using DrawStatus = decltype(renderer.draw_strip(std::uint16_t{}, std::span<std::byte>{}));
  PresentResult<DrawStatus> result;

  const StripAreas areas(layout, display.width(), display.height());
  if (!areas.cover()) {
    result.display = Error::strip_layout;
    return result;
  }
  const std::uint32_t strip_bytes = areas.bytes(display.format());
  const bool alternate = !buffers.second.empty();
  if (buffers.first.size() < strip_bytes || (alternate && buffers.second.size() < strip_bytes)) {
    result.display = Error::pixels_too_small;
    return result;
  }
  result.display = display.begin_frame();
  if (result.display != Error::none) return result;

  std::span<std::byte> drawing = buffers.first;
  std::span<std::byte> sending = alternate ? buffers.second : buffers.first;
  for (std::uint16_t strip = 0; result && strip < layout.count; ++strip) {
    result.strip = strip;
    const Area area = areas.area(strip);
    if constexpr (HasFingerprints<Renderer> && RemembersStrips<Panel>) {
      if (display.shows(area, renderer.fingerprint(strip))) continue;
    }
    if (!alternate) result.display = display.wait();
    if (!result) break;
    result.draw = renderer.draw_strip(strip, drawing);
    if (!result) break;
    result.display = display.wait();
    if (!result) break;
    result.display = display.write(area, drawing.first(area.height * bytes_per_row(area.width, display.format())));
    std::swap(drawing, sending);
  }

  // The display must be idle before the buffers are reused, also after an error. Only the first error is reported.
  const Error last_transfer = display.wait();
  const Error end = display.end_frame();
  if (result) result.display = last_transfer != Error::none ? last_transfer : end;
  return result;
}

}  // namespace zstrip::hal
