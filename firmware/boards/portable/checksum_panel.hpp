// A display without a screen: takes rectangles as a panel does and keeps only the checksum of the picture. It takes the
// place of the driver of a panel on SPI.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "portable/picture_crc32.hpp"
#include "zstrip_hal/display.hpp"

namespace zstrip::board {

/// 16 bits a pixel, high byte first, the format of SPI panels.
template <std::uint16_t panel_width, std::uint16_t panel_height>
class ChecksumPanel {
 public:
  constexpr std::uint16_t width() const { return panel_width; }
  constexpr std::uint16_t height() const { return panel_height; }
  constexpr hal::DisplayFormat format() const { return hal::DisplayFormat::rgb565_swapped; }

  hal::Error begin_frame() {
    crc_ = PictureCrc32(kRowBytes * panel_height);
    return hal::Error::none;
  }
  hal::Error write(const hal::Area& area, std::span<const std::byte> pixels) {
    if (!contains(panel_width, panel_height, area)) return hal::Error::area;
    const std::uint32_t row_bytes = bytes_per_row(area.width, format());
    if (pixels.size() < row_bytes * area.height) return hal::Error::pixels_too_small;
    const std::uint32_t offset = kRowBytes * area.top + bytes_per_row(area.left, format());
    if (row_bytes == kRowBytes) {
      crc_.add(offset, pixels.first(row_bytes * area.height));
      return hal::Error::none;
    }
    for (std::uint32_t row = 0; row < area.height; ++row) {
      crc_.add(offset + row * kRowBytes, pixels.subspan(row * row_bytes, row_bytes));
    }
    return hal::Error::none;
  }
  hal::Error wait() { return hal::Error::none; }
  /// Returns Error::strip_layout if the rectangles since begin_frame are not the whole picture.
  hal::Error end_frame() { return crc_.complete() ? hal::Error::none : hal::Error::strip_layout; }

  /// Returns zlib's CRC-32 of the last complete frame.
  std::uint32_t crc32() const { return crc_.value(); }

 private:
  static constexpr std::uint32_t kRowBytes = bytes_per_row(panel_width, hal::DisplayFormat::rgb565_swapped);
  PictureCrc32 crc_{kRowBytes * panel_height};
};

static_assert(hal::Display<ChecksumPanel<1, 1>>);

}  // namespace zstrip::board
