// A picture in memory that hardware, or an operating system, shows on a screen.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

#include "zstrip_hal/display.hpp"
#include "zstrip_hal/error.hpp"

namespace zstrip::hal {

/// The position of a picture's rows in memory, and their pixel format.
struct FramebufferLayout {
  std::uint16_t width = 0;                       ///< pixels
  std::uint16_t height = 0;                      ///< pixels
  DisplayFormat format = DisplayFormat::rgb565;  ///< format of the memory, and of the pixels that write() takes
  std::uint32_t stride = 0;                      ///< bytes from one row to the next; 0: rows without gaps
};

/// write() copies a rectangle into the memory and has ended when it returns. There is one buffer, so the screen shows
/// each rectangle as soon as it is written. The caller owns the memory, which must outlive the display; a processor
/// with a data cache either maps it uncached or cleans it after end_frame().
/// Accepts every format. In formats whose pixels share bytes a rectangle must begin at a whole byte, and end at a
/// whole byte or at the picture's right edge.
class Framebuffer {
 public:
  /// Does not access the memory; begin_frame() checks it.
  constexpr Framebuffer(std::span<std::byte> memory, const FramebufferLayout& layout)
      : memory_(memory),
        layout_(layout),
        stride_(layout.stride != 0 ? layout.stride : bytes_per_row(layout.width, layout.format)) {}

  /// @{
  /// See the concept Display.
  constexpr std::uint16_t width() const { return layout_.width; }
  constexpr std::uint16_t height() const { return layout_.height; }
  constexpr DisplayFormat format() const { return layout_.format; }

  /// Returns Error::framebuffer if rows overlap, or do not fit the memory.
  constexpr Error begin_frame() { return fits() ? Error::none : Error::framebuffer; }

  Error write(const Area& area, std::span<const std::byte> pixels) {
    if (!fits()) return Error::framebuffer;
    if (!contains(layout_.width, layout_.height, area)) return Error::area;
    const std::uint32_t bits = bytes_per_row(8, layout_.format);  // bits of a pixel
    const bool to_the_edge = area.left + area.width == layout_.width;
    if (area.left * bits % 8 != 0 || (area.width * bits % 8 != 0 && !to_the_edge)) return Error::alignment;
    const std::size_t row_bytes = bytes_per_row(area.width, layout_.format);
    if (pixels.size() < row_bytes * area.height) return Error::pixels_too_small;
    std::byte* row = memory_.data() + std::size_t{stride_} * area.top + area.left * bits / 8;
    for (const std::byte* from = pixels.data(); from != pixels.data() + row_bytes * area.height; from += row_bytes) {
      std::memcpy(row, from, row_bytes);
      row += stride_;
    }
    return Error::none;
  }

  constexpr Error wait() { return Error::none; }
  constexpr Error end_frame() { return Error::none; }
  /// @}

 private:
  constexpr bool fits() const {
    const std::uint32_t row = bytes_per_row(layout_.width, layout_.format);
    return row != 0 && layout_.height != 0 && stride_ >= row && row <= memory_.size() &&
           (memory_.size() - row) / stride_ >= layout_.height - 1U;
  }

  std::span<std::byte> memory_;
  FramebufferLayout layout_;
  std::uint32_t stride_;
};

static_assert(Display<Framebuffer>);

}  // namespace zstrip::hal
