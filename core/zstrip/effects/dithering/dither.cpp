// Dithered pixels stay RGB565. They contain the level that a format keeps, so that one conversion serves all formats.
#include "zstrip/effects/dithering/dither.hpp"

#include "zstrip/base/bayer.hpp"
#include "zstrip/resolve/resolve.hpp"

namespace zstrip {
namespace {

/// Returns levels of 4 bits in the upper bits of the channels; such a grey's luma has the level in its upper 4 bits.
constexpr std::uint16_t of_levels(std::uint32_t r, std::uint32_t g, std::uint32_t b) {
  return static_cast<std::uint16_t>((r << 12) | (g << 7) | (b << 1));
}

std::uint16_t dithered_for(PixelFormat format, std::uint16_t pixel, std::uint32_t threshold) {
  if (format == PixelFormat::mono) return detail::dithered<1>(detail::luma(pixel), threshold) != 0 ? 0xFFFF : 0;
  if (format == PixelFormat::gray4) {
    const std::uint32_t level = detail::dithered<4>(detail::luma(pixel), threshold);
    return of_levels(level, level, level);
  }
  const std::uint32_t r5 = pixel >> 11, g6 = (pixel >> 5) & 0x3FU, b5 = pixel & 0x1FU;
  return of_levels(detail::dithered<4>((r5 << 3) | (r5 >> 2), threshold),
                   detail::dithered<4>((g6 << 2) | (g6 >> 4), threshold),
                   detail::dithered<4>((b5 << 3) | (b5 >> 2), threshold));
}

}  // namespace

void dither_pixels(PixelFormat format, const Rect& area, std::uint16_t* pixels) {
  if (!is_narrow(format)) return;
  for (std::int32_t y = area.top; y < area.bottom; ++y) {
    for (std::int32_t x = area.left; x < area.right; ++x, ++pixels) {
      *pixels = dithered_for(format, *pixels, detail::kBayer[y & 7][x & 7]);
    }
  }
}

}  // namespace zstrip
