// A display whose panel is memory: what the strips leave behind is the picture.
#include "render/picture_display.hpp"

#include <algorithm>

namespace zstrip::sim {

static_assert(hal::Display<PictureDisplay>);

hal::PixelFormat PictureDisplay::format() const {
  switch (view_.format) {
    case PixelFormat::rgb565: return hal::PixelFormat::rgb565;
    case PixelFormat::rgb565_swapped: return hal::PixelFormat::rgb565_swapped;
    case PixelFormat::gray4: return hal::PixelFormat::gray4;
    case PixelFormat::mono: return hal::PixelFormat::mono;
  }
  return hal::PixelFormat::rgb565;
}

hal::Error PictureDisplay::write(const hal::Area& area, std::span<const std::byte> pixels) {
  if (!hal::contains(view_.width, view_.height, area) || area.width != view_.width) return hal::Error::area;
  const std::size_t row_bytes = bytes_per_row(view_.width, view_.format);
  const std::size_t bytes = row_bytes * area.height;
  if (pixels.size() < bytes) return hal::Error::pixels_too_small;
  std::copy_n(pixels.begin(), bytes, pixels_.begin() + static_cast<std::ptrdiff_t>(row_bytes * area.top));
  return hal::Error::none;
}

}  // namespace zstrip::sim
