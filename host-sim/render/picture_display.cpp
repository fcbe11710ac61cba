// A display whose panel is memory: the picture consists of the strips that were written.
#include "render/picture_display.hpp"

#include <algorithm>

namespace zstrip::sim {

static_assert(hal::Display<PictureDisplay>);

// tests/panels checks that both lists are equal.
hal::DisplayFormat hal_format(PixelFormat format) { return static_cast<hal::DisplayFormat>(format); }
PixelFormat core_format(hal::DisplayFormat format) { return static_cast<PixelFormat>(format); }

hal::Error PictureDisplay::write(const hal::Area& area, std::span<const std::byte> pixels) {
  constexpr std::uint16_t kPixelsOfAByte = 8;  // of the format with the most pixels a byte
  const bool splits_bytes =
      area.left % kPixelsOfAByte != 0 || (area.width % kPixelsOfAByte != 0 && area.left + area.width != view_.width);
  if (!hal::contains(view_.width, view_.height, area) || splits_bytes) return hal::Error::area;
  const std::size_t row_bytes = bytes_per_row(area.width, view_.format);
  if (pixels.size() < row_bytes * area.height) return hal::Error::pixels_too_small;
  const std::size_t picture_row_bytes = bytes_per_row(view_.width, view_.format);
  const std::size_t first_byte = picture_row_bytes * area.top + bytes_per_row(area.left, view_.format);
  for (std::size_t y = 0; y < area.height; ++y) {
    std::copy_n(pixels.begin() + static_cast<std::ptrdiff_t>(y * row_bytes), row_bytes,
                pixels_.begin() + static_cast<std::ptrdiff_t>(first_byte + y * picture_row_bytes));
  }
  return hal::Error::none;
}

}  // namespace zstrip::sim
