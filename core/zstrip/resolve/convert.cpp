// The choice of the format; see resolve.hpp for the rows.
#include "zstrip/resolve/convert.hpp"

#include "zstrip/resolve/resolve.hpp"

namespace zstrip {

void convert_pixels(PixelFormat format, std::uint16_t width, std::uint16_t rows, std::uint16_t* pixels,
                    std::byte* out) {
  if (format == PixelFormat::rgb565) return;
  if (format == PixelFormat::rgb565_swapped) {
    detail::swap_bytes(pixels, std::uint32_t{rows} * width);
    return;
  }
  for (std::uint32_t y = 0; y < rows; ++y) {
    const std::uint16_t* const row = pixels + y * width;
    std::byte* const out_row = out + y * bytes_per_row(width, format);
    if (format == PixelFormat::gray4) {
      detail::resolve_gray4(row, width, out_row);
    } else if (format == PixelFormat::mono) {
      detail::resolve_mono(row, width, out_row);
    } else if (format == PixelFormat::rgb444) {
      detail::resolve_rgb444(row, width, out_row);
    } else {
      detail::resolve_wide(row, width, format == PixelFormat::xrgb8888, out_row);
    }
  }
}

}  // namespace zstrip
