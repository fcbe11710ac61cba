// Takes pixels apart, for every picture format.
#include "picture_summary.hpp"

namespace zstrip::targets {
namespace {

/// The pixel of a row at column x, in the view's own format; 16-bit pixels with red in the highest bits.
std::uint32_t pixel_at(const std::byte* row, std::uint32_t x, PixelFormat format) {
  const auto byte = [row](std::uint32_t index) { return std::to_integer<std::uint32_t>(row[index]); };
  switch (format) {
    case PixelFormat::rgb565: return byte(2 * x) | byte(2 * x + 1) << 8;
    case PixelFormat::rgb565_swapped: return byte(2 * x) << 8 | byte(2 * x + 1);
    case PixelFormat::gray4: return (byte(x / 2) >> (x % 2 == 0 ? 4 : 0)) & 15U;
    case PixelFormat::mono: return (byte(x / 8) >> (7 - x % 8)) & 1U;
    case PixelFormat::rgb666: return byte(3 * x) << 16 | byte(3 * x + 1) << 8 | byte(3 * x + 2);
    case PixelFormat::rgb444: {
      const std::uint32_t first = x / 2 * 3;
      return x % 2 == 0 ? byte(first) << 4 | byte(first + 1) >> 4 : (byte(first + 1) & 15U) << 8 | byte(first + 2);
    }
    case PixelFormat::xrgb8888: return byte(4 * x) | byte(4 * x + 1) << 8 | byte(4 * x + 2) << 16;
  }
  return 0;
}

}  // namespace

void PictureSummary::add_pixels(std::span<const std::byte> pixels, std::uint32_t top, std::uint32_t rows) {
  pixels_.add(pixels);
  const std::uint32_t row_bytes = bytes_per_row(view_.width, view_.format);
  for (std::uint32_t row = 0; row < rows; ++row) {
    for (std::uint32_t x = 0; x < view_.width; ++x) {
      add_pixel(static_cast<std::int32_t>(x), static_cast<std::int32_t>(top + row),
                pixel_at(pixels.data() + row * row_bytes, x, view_.format));
    }
  }
}

void PictureSummary::add_depth(std::span<const std::uint16_t> codes) {
  for (const std::uint16_t code : codes) {
    const std::byte bytes[] = {static_cast<std::byte>(code & 0xFFU), static_cast<std::byte>(code >> 8)};
    depth_.add(bytes);
  }
}

void PictureSummary::add_depth(std::span<const std::uint32_t> codes) {
  for (const std::uint32_t code : codes) {
    const std::uint16_t words[] = {static_cast<std::uint16_t>(code & 0xFFFFU), static_cast<std::uint16_t>(code >> 16)};
    add_depth(std::span<const std::uint16_t>(words));
  }
}

void PictureSummary::add_pixel(std::int32_t x, std::int32_t y, std::uint32_t pixel) {
  const bool coloured = view_.format == PixelFormat::rgb565 || view_.format == PixelFormat::rgb565_swapped;
  red_ += coloured ? pixel >> 11 : pixel;
  green_ += coloured ? (pixel >> 5) & 0x3FU : pixel;
  blue_ += coloured ? pixel & 0x1FU : pixel;
  if (pixel == 0) return;
  if (box_.empty()) {
    box_ = {x, y, x + 1, y + 1};
    return;
  }
  if (x < box_.left) box_.left = x;
  if (y < box_.top) box_.top = y;
  if (x >= box_.right) box_.right = x + 1;
  if (y >= box_.bottom) box_.bottom = y + 1;
}

}  // namespace zstrip::targets
